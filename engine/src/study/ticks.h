#pragma once

#include <cstdint>

/// When runs of a study are looked at. The horizon is cut into ticks; energies are read at each, positions
/// are compared at forty outputs of the whole horizon and at twenty of its first tenth.

namespace hooke::study {

inline constexpr unsigned last_tick = 200;
inline constexpr unsigned ticks_between_outputs = 5;
inline constexpr unsigned short_horizon = 20;  ///< [ticks]

constexpr bool is_output(unsigned tick) {
  return tick > 0 && (tick <= short_horizon || tick % ticks_between_outputs == 0);
}

/// Runs take multiples of this number of steps to the horizon, so that all meet every second output; but of
/// `last_tick` where they must meet another tick.
inline constexpr std::uint64_t fewest_steps = 20;
inline constexpr unsigned ticks_met_by_all = last_tick / fewest_steps;

/// Whether a run of so many steps to the horizon has a state at this tick.
constexpr bool meets(std::uint64_t steps, unsigned tick) {
  return steps * tick % last_tick == 0;
}

}  // namespace hooke::study
