#include "viewer/live/live_simulation.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "viewer/live/step_limit.h"

namespace hooke::viewer {
namespace {

template <class Real>
Vec3 at(std::span<const Real> x, std::span<const Real> y, std::span<const Real> z, Index i) {
  return {double(x[i]), double(y[i]), double(z[i])};
}

}  // namespace

template <class Real>
LiveSimulation<Real>::LiveSimulation(Scene scene, Settings settings)
    : scene_(std::move(scene)), simulation_(scene_, std::move(settings)), start_(simulation_.snapshot()) {
  tears_.look_at(simulation_);
}

template <class Real>
void LiveSimulation<Real>::change(Setup setup) {
  std::swap(scene_.effects, setup.effects);
  try {
    Simulation<Real> changed(scene_, setup.settings);
    Snapshot<Real> state = simulation_.snapshot();
    state.torn = nullptr;  // it is the scene that the changed one starts from
    state.torn_from.clear();
    changed.restore(state);
    simulation_ = std::move(changed);
  } catch (...) {
    std::swap(scene_.effects, setup.effects);
    throw;
  }
  if (drag_) drag(*drag_);  // its spring goes by the length of the steps
}

template <class Real>
void LiveSimulation<Real>::reset() {
  if (!whole_) {
    simulation_.restore(start_);
    return;
  }
  simulation_ = Simulation<Real>(*whole_, simulation_.settings());
  simulation_.restore(start_);
  scene_ = *std::exchange(whole_, std::nullopt);
  tears_ = {};
  tears_.look_at(simulation_);
  if (drag_ && drag_->particle >= scene_.particles.size()) release();
}

template <class Real>
void LiveSimulation<Real>::look_for_tears() {
  if (!tears_.look_at(simulation_)) return;
  if (!whole_) whole_ = scene_;
  scene_ = tears_.scene() ? *tears_.scene() : scene_;
}

template <class Real>
void LiveSimulation<Real>::drag(const Pull& drag) {
  if (drag.particle >= scene_.particles.size())
    throw std::out_of_range("drag: there is no particle " + std::to_string(drag.particle));
  drag_ = drag;
  const Settings& settings = simulation_.settings();
  const double step = chooses_steps(settings.method) ? 0.0 : settings.step;
  spring_ = drag_spring(scene_, scene_.particles.mass[drag.particle], step);
}

template <class Real>
void LiveSimulation<Real>::pull() {
  const StateView<Real> state = simulation_.state();
  const Index i = simulation_.engine_index(drag_->particle);
  const Vec3 position = at(state.x, state.y, state.z, i), velocity = at(state.vx, state.vy, state.vz, i);
  simulation_.apply_impulse(drag_->particle,
                            drag_impulse(spring_, scene_.particles.mass[drag_->particle],
                                         simulation_.settings().step, drag_->target - position, velocity));
}

template <class Real>
Report LiveSimulation<Real>::take_steps(std::uint64_t count, Work& work) {
  const std::uint64_t at_once = drag_ ? 1 : count;
  Report report;
  for (std::uint64_t taken = 0; taken < count && report.ok(); taken += at_once) {
    if (drag_) pull();
    report = simulation_.step(at_once);
    work.add(report);
    look_for_tears();
  }
  return report;
}

template class LiveSimulation<float>;
template class LiveSimulation<double>;

}  // namespace hooke::viewer
