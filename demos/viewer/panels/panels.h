#pragma once

#include "viewer/state.h"

/// The panels of the column at the left, each in a file of its own, and what lies over the scene. Each draws
/// into ImGui's window that is open, or opens its own.

namespace hooke::viewer {

/// Pause, step, reset, speed; how fast it goes.
void run_panel(State& state);
/// Method, step, threads, accumulation, stability; what more accuracy would cost.
void method_panel(State& state);
/// The coefficients of the effects that the scene names.
void effects_panel(State& state);
/// The longest stable step against today's, where there is one; a part of the above.
void stability_gauge(State& state);
/// The time of each sweep of the plan.
void stages_panel(State& state);
/// Energies over time, and the largest strain.
void energy_panel(State& state);
/// What is drawn.
void picture_panel(State& state);

/// The study of accuracy, over the scene. `left` is where the scene begins; all in the units of the mouse.
void study_window(State& state, float left);
/// Why the run stopped, or a change was not made, over the scene.
void banner(State& state, float left);
/// All shortcuts, over the scene.
void help_window(State& state, float left);

}  // namespace hooke::viewer
