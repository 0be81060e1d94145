#include "viewer/live/drag_spring.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace hooke::viewer {
namespace {

double moving_mass(const Scene& scene) {
  double sum = 0.0;
  for (const double mass : scene.particles.mass) sum += mass;
  for (const Pin& pin : scene.pins) sum -= scene.particles.mass[pin.particle];
  return sum;
}

/// Diagonal of the box around all particles [m].
double size_of(const Scene& scene) {
  Eigen::AlignedBox3d box;
  for (const Vec3& position : scene.particles.position) box.extend(position);
  const double size = box.isEmpty() ? 0.0 : box.diagonal().norm();
  return size > 0.0 ? size : 1.0;  // a single particle, or all at one place
}

}  // namespace

DragSpring drag_spring(const Scene& scene, double mass, double step) {
  constexpr double gravity = 9.81;  // [m/s^2], also where the scene has none
  const double all = std::max(moving_mass(scene), mass);
  const double stiffness = std::min(8.0 * all * gravity / size_of(scene), mass / (50.0 * step * step));
  const double damping = 2.0 * std::sqrt(stiffness * std::sqrt(mass * all));
  return {stiffness, std::min(damping, mass / (20.0 * step))};
}

Vec3 drag_impulse(const DragSpring& spring, double mass, double step, const Vec3& offset,
                  const Vec3& velocity) {
  const Vec3 force = spring.stiffness * (offset - step * velocity) - spring.damping * velocity;
  return step * force / (1.0 + step * (spring.damping + step * spring.stiffness) / mass);
}

}  // namespace hooke::viewer
