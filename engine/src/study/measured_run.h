#pragma once

#include <cmath>
#include <vector>

#include <hooke/study.h>

#include "study/reference_solution.h"
#include "study/sampled_run.h"

namespace hooke::study {

/// A sample, and at trusted outputs how far its positions are from the reference's.
struct MeasuredSample {
  Sample sample;
  double rms_error = not_measured, max_error = not_measured;  ///< [1] of the scene's size
};

/// A run that was compared with the reference.
struct MeasuredRun {
  RunPlan plan;
  MethodChoice choice;
  std::vector<MeasuredSample> samples;  ///< at each tick that its steps meet, from the start on
  RunEnd end = RunEnd::reached;
  double diverged_at = not_measured;  ///< [s] of simulated time
  std::uint64_t force_evaluations = 0;
  double seconds = 0.0;  ///< [s] of wall time in steps
  unsigned repeats = 1;

  const MeasuredSample* at(unsigned tick) const;
};

/// Makes a run up to `until` and compares it. It has diverged where a step goes bad, or where its energy
/// differs from the reference's by more than a thousand times the energy that moves.
MeasuredRun measure_run(const Scene& scene, const StudySettings& settings, const RunPlan& plan,
                        const ReferenceSolution& reference, unsigned until, double deadline,
                        StudyClock& clock);

/// Makes the run again, only to time it: at each of the ticks the least time is kept.
void time_again(const Scene& scene, const StudySettings& settings, const std::vector<unsigned>& ticks,
                double deadline, StudyClock& clock, MeasuredRun& run);

}  // namespace hooke::study
