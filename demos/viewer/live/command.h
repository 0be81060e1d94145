#pragma once

#include <variant>

#include "viewer/live/setup.h"

/// What a viewer can ask of a running simulation.

namespace hooke::viewer {

struct SetRunning {
  bool running = true;
};

/// Takes one step of a simulation that is paused.
struct StepOnce {};

/// Goes back to the state at the start; what was changed stays changed.
struct Reset {};

/// Simulated seconds for each second of wall time [1], > 0.
struct SetSpeed {
  double speed = 1.0;
};

/// Goes on from the same state with another method, step or effects.
struct Change {
  Setup setup;
};

/// Pulls a particle towards a place [m], from now until Release.
struct Pull {
  Index particle = 0;
  Vec3 target = Vec3::Zero();
};

struct Release {};

using Command = std::variant<SetRunning, StepOnce, Reset, SetSpeed, Change, Pull, Release>;

}  // namespace hooke::viewer
