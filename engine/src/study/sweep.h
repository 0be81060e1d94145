#pragma once

#include <vector>

#include <hooke/study.h>

#include "study/measured_run.h"
#include "study/step_limits.h"

namespace hooke::study {

/// What a sweep over all methods gave.
struct Sweep {
  std::vector<MeasuredRun> runs;       ///< by method, from coarse to fine
  std::vector<MeasuredRun> long_runs;  ///< of each method one, to the end of the study's horizon; by method
  std::vector<OmittedRun> omitted;
  bool stopped = false;
};

/// Runs every method to the last of `horizons` [ticks] from coarse to fine, always the cheapest run next,
/// until all has been shown or the budget is spent. Where that is not the end of the study's horizon, part of
/// the budget is kept for long runs: for each method the coarsest that kept to the tolerance, or else was
/// stable.
Sweep sweep_methods(const Scene& scene, const StudySettings& settings, const StepLimits& limits,
                    const ReferenceSolution& reference, const std::vector<unsigned>& horizons,
                    StudyClock& clock);

}  // namespace hooke::study
