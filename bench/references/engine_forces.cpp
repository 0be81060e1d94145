#include "engine_forces.h"

#include <algorithm>

namespace hooke::reference {
namespace {

std::vector<double> corners_of(const std::vector<MovingPin>& pins) {
  std::vector<double> times;
  for (const MovingPin& pin : pins) {
    for (const Keyframe& keyframe : pin.path) times.push_back(keyframe.time);
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace

EngineForces::EngineForces(const Scene& scene)
    : executor_(make_tbb_executor(1)),
      model_(scene, Accumulation::gather, *executor_),
      forces_(scene, model_),
      state_(initial_state(scene, model_)),
      force_(block_count(model_.particles()) * block_size),
      corners_(corners_of(model_.moving_pins)) {
  for (Index i = 0; i < scene.particles.size(); ++i) {
    if (model_.inverse_mass[model_.order.engine(i)] > 0.0) free_.push_back(i);
  }
  for (Index i : free_) {
    const Vec3 x = state_.position(model_.order.engine(i));
    start_.insert(start_.end(), x.begin(), x.end());
  }
  for (Index i : free_) {
    const Vec3 v = state_.velocity(model_.order.engine(i));
    start_.insert(start_.end(), v.begin(), v.end());
  }
}

void EngineForces::set_state(double time, std::span<const double> y) {
  const double *x = y.data(), *v = y.data() + y.size() / 2;
  for (Index i : free_) {
    const Index e = model_.order.engine(i);
    state_.set_position(e, Vec3(x[0], x[1], x[2]));
    state_.set_velocity(e, Vec3(v[0], v[1], v[2]));
    x += 3;
    v += 3;
  }
  move_pins(std::span(model_.moving_pins), time, state_);
}

void EngineForces::derivative(double time, std::span<const double> y, std::span<double> result) {
  ++calls_;
  set_state(time, y);
  StripForce<double> force;
  for_each_strip(0, block_count(model_.particles()), [&](std::size_t begin, std::size_t end) {
    const Strip<double> strip(state_, begin, end);
    forces_.on_strip(strip, state_, time, force);
    for (std::size_t lane = 0; lane < strip.lanes; ++lane)
      force_[strip.first + lane] = {force.x[lane], force.y[lane], force.z[lane]};
  });
  std::copy(y.begin() + std::ptrdiff_t(y.size() / 2), y.end(), result.begin());
  double* acceleration = result.data() + result.size() / 2;
  for (Index i : free_) {
    const Index e = model_.order.engine(i);
    const Vec3 a = model_.inverse_mass[e] * force_[e];
    acceleration = std::copy(a.begin(), a.end(), acceleration);
  }
}

}  // namespace hooke::reference
