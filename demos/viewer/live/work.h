#pragma once

#include <cstdint>
#include <vector>

#include <hooke/report.h>

namespace hooke::viewer {

/// What steps took, summed up.
struct Work {
  std::uint64_t steps = 0, force_evaluations = 0;
  std::vector<double> sweeps;  ///< [s] of each sweep of the plan

  void add(const Report& report) {
    steps += report.steps_taken;
    force_evaluations += report.force_evaluations;
    sweeps.resize(report.sweeps.size());
    for (std::size_t i = 0; i < report.sweeps.size(); ++i) sweeps[i] += report.sweeps[i].seconds;
  }
};

}  // namespace hooke::viewer
