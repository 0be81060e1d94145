#include "viewer/floor.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace hooke::viewer {
namespace {

Eigen::AlignedBox3d box_of_pins(const Scene& scene) {
  Eigen::AlignedBox3d box;
  for (const Pin& pin : scene.pins) box.extend(scene.particles.position[pin.particle]);
  return box;
}

/// The lowest place that a particle has at the start, or will have when it hangs straight down from the pins.
double lowest_expected(const Scene& scene, const Vec3& up) {
  const Eigen::AlignedBox3d pins = box_of_pins(scene);
  double lowest = std::numeric_limits<double>::infinity(), lowest_pin = lowest, reach = 0.0;
  for (const Pin& pin : scene.pins)
    lowest_pin = std::min(lowest_pin, scene.particles.position[pin.particle].dot(up));
  for (const Vec3& position : scene.particles.position) {
    lowest = std::min(lowest, position.dot(up));
    if (!pins.isEmpty()) reach = std::max(reach, pins.exteriorDistance(position));
  }
  if (scene.particles.position.empty()) return 0.0;
  return pins.isEmpty() ? lowest : std::min(lowest, lowest_pin - reach);
}

double diagonal_of(const Scene& scene) {
  Eigen::AlignedBox3d box;
  for (const Vec3& position : scene.particles.position) box.extend(position);
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

}  // namespace

Floor::Floor(const Scene& scene, const Vec3& up)
    : up_(up), lowest_(lowest_expected(scene, up)), margin_(0.06 * diagonal_of(scene)) {}

void Floor::make_room(std::span<const float> positions) {
  const Eigen::Vector3f up = up_.cast<float>();
  for (std::size_t i = 0; i + 2 < positions.size(); i += 3) {
    const float height = positions[i] * up[0] + positions[i + 1] * up[1] + positions[i + 2] * up[2];
    if (std::isfinite(height)) lowest_ = std::min(lowest_, double(height));
  }
}

}  // namespace hooke::viewer
