#include "study/reference_scales.h"

#include <algorithm>
#include <cmath>

#include "study/position_error.h"

namespace hooke::study {
namespace {

double size_of(const Scene& scene, const ReferenceSolution& solution) {
  BoundingBox start, motion;
  for (const Vec3& position : scene.particles.position) start.add({position.data(), 3});
  if (start.diagonal() > 0.0) return start.diagonal();
  for (const std::vector<double>& positions : solution.positions) motion.add(positions);
  return motion.diagonal();
}

double free_mass(const Scene& scene) {
  double sum = 0.0;
  for (const double mass : scene.particles.mass) sum += mass;
  for (const Pin& pin : scene.pins) sum -= scene.particles.mass[pin.particle];
  return std::max(0.0, sum);
}

}  // namespace

void find_scales(const Scene& scene, ReferenceSolution& solution) {
  solution.scene_size = size_of(scene, solution);
  const auto potential = [](const Sample& sample) { return sample.energy.elastic + sample.energy.external; };
  const std::vector<Sample>& first = solution.samples[0];
  double kinetic = 0.0, moved = 0.0;
  for (const Sample& sample : first) {
    kinetic = std::max(kinetic, sample.energy.kinetic);
    moved = std::max(moved, std::abs(potential(sample) - potential(first.front())));
  }
  solution.energy_scale = std::max(kinetic, moved);
  solution.momentum_scale = std::sqrt(2.0 * free_mass(scene) * kinetic);
}

}  // namespace hooke::study
