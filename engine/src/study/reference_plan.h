#pragma once

#include <hooke/study.h>

#include "study/sampled_run.h"
#include "study/step_limits.h"

namespace hooke::study {

/// A reference that is to be made.
struct ReferencePlan {
  RunPlan run;
  double seconds = 0.0;  ///< [s] of wall time that it is expected to take
};

/// A reference of a method that chooses its steps, at the smallest tolerance that is worth it and that its
/// share of the budget allows: a run at a larger one is tried first, as cost goes with the fifth root of the
/// tolerance.
ReferencePlan plan_of_chosen_steps(const Scene& scene, const StudySettings& settings,
                                   const StepLimits& limits, StudyClock& clock);

/// A reference of fixed steps: as many as are worth it and its share of the budget allows, but enough to be
/// stable.
ReferencePlan plan_of_fixed_steps(const Scene& scene, const StudySettings& settings, const StepLimits& limits,
                                  StudyClock& clock);

}  // namespace hooke::study
