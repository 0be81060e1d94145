#include "viewer/study_control.h"

namespace hooke::viewer {
namespace {

void go_on(State& state) {
  if (state.study.resume) state.simulation.send(SetRunning{true});
  state.study.resume = false;
}

}  // namespace

void open_study(State& state) {
  state.study.shown = true;
  if (!state.study.running) start_study(state);
}

void start_study(State& state) {
  StudySettings settings;
  settings.horizon = state.study.seconds;
  settings.budget = state.study.budget;
  settings.accumulation = state.wanted.settings.accumulation;
  settings.threads = state.wanted.settings.threads;
  settings.executor = state.wanted.settings.executor;
  Scene scene = state.scene;
  scene.effects = state.wanted.effects;
  state.study.resume = state.study.resume || state.moment().running;
  state.simulation.send(SetRunning{false});
  state.study.running = std::make_unique<StudyThread>(std::move(scene), settings);
}

void close_study(State& state) {
  state.study.shown = false;
  if (state.study.running && !state.study.running->done()) state.study.running.reset();
  go_on(state);
}

void tend_study(State& state) {
  if (state.study.running && state.study.running->done()) go_on(state);
}

}  // namespace hooke::viewer
