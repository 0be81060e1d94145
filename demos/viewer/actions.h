#pragma once

#include "viewer/state.h"

namespace hooke::viewer {

/// What keys and buttons do.
enum class Action {
  toggle_running,
  step,
  reset,
  faster,
  slower,
  fit,
  toggle_surface,
  toggle_springs,
  toggle_particles,
  toggle_pins,
  toggle_panels,
  toggle_study,
  save_picture,
  toggle_help,
  leave,
  quit,
};

void perform(Action action, State& state);

/// Simulated seconds for each second of wall time [1] that can be asked for.
inline constexpr double slowest = 1.0 / 256.0, fastest = 256.0;

}  // namespace hooke::viewer
