#pragma once

#include <cstdint>

#include <hooke/hooke.h>

namespace hooke::bench {

/// Times of two simulations that take steps by turns.
struct PairedTimes {
  double first, second;  ///< medians [s] of a step
  double ratio;          ///< median of the ratios second / first of each turn
};

/// `turns` times, each simulation takes `steps` steps, now the one first and now the other. Throws
/// std::runtime_error with the report's message if a step goes bad.
PairedTimes paired_times(Simulation<float>& first, Simulation<float>& second, std::uint64_t steps, int turns);

}  // namespace hooke::bench
