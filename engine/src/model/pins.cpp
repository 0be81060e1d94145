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
  std::sort(pins.begin(), pins.end(),
            [](const MovingPin& a, const MovingPin& b) { return a.particle < b.particle; });
  return pins;
}

std::span<const MovingPin> pins_between(const std::vector<MovingPin>& pins, std::size_t first,
                                        std::size_t last) {
  const auto before = [](const MovingPin& pin, std::size_t particle) { return pin.particle < particle; };
  const auto begin = std::lower_bound(pins.begin(), pins.end(), first, before);
  return {begin, std::lower_bound(begin, pins.end(), last, before)};
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
void move_pins(std::span<const MovingPin> pins, double time, State<Real>& state) {
  for (const MovingPin& pin : pins) {
    const Vec3 position = pin.start + displacement_at(pin.path, time);
    const Vec3 velocity = velocity_at(pin.path, time);
    state.set_position(pin.particle, position.cast<Real>());
    state.set_velocity(pin.particle, velocity.cast<Real>());
  }
}

template void move_pins(std::span<const MovingPin>, double, State<float>&);
template void move_pins(std::span<const MovingPin>, double, State<double>&);

}  // namespace hooke
