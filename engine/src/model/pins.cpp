#include "model/pins.h"

#include <algorithm>

namespace hooke {
namespace {

/// The first keyframe later than `time`.
auto next_keyframe(const std::vector<Keyframe>& path, double time) {
  return std::upper_bound(path.begin(), path.end(), time,
                          [](double t, const Keyframe& keyframe) { return t < keyframe.time; });
}

}  // namespace

std::vector<MovingPin> moving_pins(const Scene& scene, const Order& order) {
  std::vector<MovingPin> pins;
  for (const Pin& pin : scene.pins) {
    if (pin.path.empty()) continue;
    pins.push_back({order.engine(pin.particle), scene.particles.position[pin.particle], pin.path});
  }
  return pins;
}

Vec3 displacement_at(const std::vector<Keyframe>& path, double time) {
  const auto next = next_keyframe(path, time);
  if (next == path.begin()) return path.front().displacement;
  if (next == path.end()) return path.back().displacement;
  const Keyframe &a = *(next - 1), &b = *next;
  const double share = (time - a.time) / (b.time - a.time);
  return (1.0 - share) * a.displacement + share * b.displacement;
}

Vec3 velocity_at(const std::vector<Keyframe>& path, double time) {
  const auto next = next_keyframe(path, time);
  if (next == path.begin() || next == path.end()) return Vec3::Zero();
  const Keyframe &a = *(next - 1), &b = *next;
  return (b.displacement - a.displacement) / (b.time - a.time);
}

template <class Real>
void move_pins(const std::vector<MovingPin>& pins, State<Real>& state) {
  for (const MovingPin& pin : pins) {
    const Vec3 position = pin.start + displacement_at(pin.path, state.time);
    const Vec3 velocity = velocity_at(pin.path, state.time);
    state.set_position(pin.particle, position.cast<Real>());
    state.set_velocity(pin.particle, velocity.cast<Real>());
  }
}

template void move_pins(const std::vector<MovingPin>&, State<float>&);
template void move_pins(const std::vector<MovingPin>&, State<double>&);

}  // namespace hooke
