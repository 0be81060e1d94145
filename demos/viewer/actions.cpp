#include "viewer/actions.h"

#include <algorithm>

#include "viewer/study_control.h"

namespace hooke::viewer {
namespace {

void set_speed(State& state, double factor) {
  state.simulation.send(SetSpeed{std::clamp(factor * state.moment().speed, slowest, fastest)});
}

/// One thing is left at a time: the help, the study, and at last the viewer.
void leave(State& state) {
  if (state.help) {
    state.help = false;
  } else if (state.study.shown) {
    close_study(state);
  } else {
    state.closing = true;
  }
}

void toggle(bool& value) {
  value = !value;
}

}  // namespace

void perform(Action action, State& state) {
  picture::Look& look = state.view.look();
  switch (action) {
    case Action::toggle_running:
      return state.simulation.send(SetRunning{!state.moment().running});
    case Action::step:
      return state.simulation.send(StepOnce{});
    case Action::reset:
      return state.simulation.send(Reset{});
    case Action::faster:
      return set_speed(state, 2.0);
    case Action::slower:
      return set_speed(state, 0.5);
    case Action::fit:
      return state.view.fit();
    case Action::toggle_surface:
      return toggle(look.surface);
    case Action::toggle_springs:
      return toggle(look.springs);
    case Action::toggle_particles:
      return toggle(look.particles);
    case Action::toggle_pins:
      return toggle(look.pins);
    case Action::toggle_panels:
      return toggle(state.panels);
    case Action::toggle_study:
      return state.study.shown ? close_study(state) : open_study(state);
    case Action::save_picture:
      state.save_picture = true;
      return;
    case Action::toggle_help:
      return toggle(state.help);
    case Action::leave:
      return leave(state);
    case Action::quit:
      state.closing = true;
      return;
  }
}

}  // namespace hooke::viewer
