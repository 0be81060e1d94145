#pragma once

#include <vector>

#include <hooke/study.h>

#include "study/sweep.h"

namespace hooke::study {

/// What runs came to at each of the horizons [ticks].
std::vector<AccuracyRun> accuracy_rows(const std::vector<MeasuredRun>& runs,
                                       const ReferenceSolution& reference,
                                       const std::vector<unsigned>& horizons, const StudySettings& settings);

/// How energy went in one run of each method: in its long run, or else in the coarsest that got furthest.
std::vector<EnergyHistory> energy_histories(const Sweep& sweep, const StudySettings& settings);

/// Means over the time after trust, of the two references and the long run of each method.
std::vector<LongRun> long_runs(const Sweep& sweep, const ReferenceSolution& reference);

}  // namespace hooke::study
