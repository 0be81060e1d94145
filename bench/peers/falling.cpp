#include "falling.h"

#include <stdexcept>
#include <string>

#include "scene/number_text.h"

namespace hooke::bench {
namespace {

Vec3 gravity_of(const Scene& scene) {
  for (const Effect& effect : scene.effects) {
    if (const auto* gravity = std::get_if<Gravity>(&effect)) return gravity->acceleration;
  }
  throw std::logic_error("the scene has no gravity");
}

}  // namespace

double mean_fall(const Scene& scene, const std::vector<Vec3>& positions) {
  const Vec3 down = gravity_of(scene).normalized();
  double sum = 0.0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    sum += (positions[i] - scene.particles.position[i]).dot(down);
  }
  return sum / double(positions.size());
}

void require_falling(const Scene& scene, const std::vector<Vec3>& positions, double time, double step) {
  for (const Pin& pin : scene.pins) {
    const double moved = (positions[pin.particle] - scene.particles.position[pin.particle]).norm();
    if (!(moved <= 1e-6))
      throw std::runtime_error("pinned particle " + std::to_string(pin.particle) + " moved by " +
                               to_text(moved) + " m");
  }
  const double fall = mean_fall(scene, positions);
  const double free_fall = 0.5 * gravity_of(scene).norm() * time * (time + step);  // in steps of Euler
  if (!(fall > 0.0 && fall <= 1.001 * free_fall))
    throw std::runtime_error("fell by " + to_text(fall) + " m, where free fall is " + to_text(free_fall) +
                             " m");
}

}  // namespace hooke::bench
