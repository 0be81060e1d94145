#pragma once

#include "viewer/state.h"

namespace hooke::viewer {

/// Shows the study's window, and starts a study where there is none that fits.
void open_study(State& state);
/// Starts a study of the scene with today's effects; the simulation stands still until it is done.
void start_study(State& state);
/// Hides the window, and cancels a study that is not done.
void close_study(State& state);
/// Looks after a study that runs: to be called with each frame.
void tend_study(State& state);

}  // namespace hooke::viewer
