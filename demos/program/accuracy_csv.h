#pragma once

#include <string>

#include <hooke/study.h>

namespace hooke::program {

/// The runs of a study as CSV, a line for each run and horizon; numbers that were not measured are NaN.
std::string runs_csv(const AccuracyStudy& study);

/// How energy went in one run of each method, and in the reference, as CSV. The difference is from the
/// reference, as a share of the energy scale.
std::string energies_csv(const AccuracyStudy& study);

}  // namespace hooke::program
