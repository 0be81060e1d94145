#pragma once

#include <span>
#include <vector>

#include <hooke/scene.h>

#include "model/order.h"
#include "state.h"

namespace hooke {

/// A pinned particle that follows a path.
struct MovingPin {
  Index particle;  ///< in the engine's order
  Vec3 start;      ///< position at zero displacement [m]
  std::vector<Keyframe> path;
};

/// The pins of a scene that have a path, sorted by particle.
std::vector<MovingPin> moving_pins(const Scene& scene, const Order& order);

/// Displacement [m] and velocity [m/s] on a path of straight lines at `time` [s].
Vec3 displacement_at(const std::vector<Keyframe>& path, double time);
Vec3 velocity_at(const std::vector<Keyframe>& path, double time);

/// Those of the sorted pins whose particles are in [first, last).
std::span<const MovingPin> pins_between(const std::vector<MovingPin>& pins, std::size_t first,
                                        std::size_t last);

/// Puts each pin where its path is at `time` [s].
template <class Real>
void move_pins(std::span<const MovingPin> pins, double time, State<Real>& state);

}  // namespace hooke
