#pragma once

#include "viewer/interface.h"
#include "viewer/state.h"

namespace hooke::viewer {

/// Draws the column of panels at the left of the window, and returns its width [units of the mouse].
float column(State& state, const Interface& interface);

/// What is told over the scene, which begins at `left` [units of the mouse].
void overlays(State& state, float left);

}  // namespace hooke::viewer
