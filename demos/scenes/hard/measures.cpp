#include "scenes/hard/measures.h"

#include <algorithm>
#include <cmath>

namespace hooke::hard {
namespace {

Vec3 gravity_of(const Scene& scene) {
  Vec3 sum = Vec3::Zero();
  for (const Effect& effect : scene.effects) {
    if (const auto* gravity = std::get_if<Gravity>(&effect)) sum += gravity->acceleration;
  }
  return sum;
}

std::vector<bool> pinned(const Scene& scene) {
  std::vector<bool> result(scene.particles.size(), false);
  for (const Pin& pin : scene.pins) result[pin.particle] = true;
  return result;
}

}  // namespace

std::vector<double> strains(const Scene& scene, const std::vector<Vec3>& positions) {
  const Springs& springs = scene.springs;
  std::vector<double> result;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    if (springs.rest_length[s] == 0.0) continue;
    const double length = (positions[springs.second[s]] - positions[springs.first[s]]).norm();
    result.push_back(std::abs(length / springs.rest_length[s] - 1.0));
  }
  return result;
}

double share_within(const Scene& scene, const std::vector<Vec3>& positions, double limit) {
  const std::vector<double> all = strains(scene, positions);
  const auto within = std::count_if(all.begin(), all.end(), [&](double strain) { return strain <= limit; });
  return double(within) / double(all.size());
}

double largest_force(const Scene& scene, const std::vector<Vec3>& positions) {
  const Springs& springs = scene.springs;
  std::vector<Vec3> forces(positions.size());
  for (std::size_t i = 0; i < forces.size(); ++i) forces[i] = scene.particles.mass[i] * gravity_of(scene);
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const Vec3 reach = positions[springs.second[s]] - positions[springs.first[s]];
    const double length = reach.norm();
    if (length == 0.0) continue;
    const Vec3 force = springs.stiffness[s] * (1.0 - springs.rest_length[s] / length) * reach;
    forces[springs.first[s]] += force;
    forces[springs.second[s]] -= force;
  }
  const std::vector<bool> held = pinned(scene);
  double largest = 0.0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (!held[i]) largest = std::max(largest, forces[i].norm());
  }
  return largest;
}

double weight(const Scene& scene) {
  const std::vector<bool> held = pinned(scene);
  double mass = 0.0;
  for (std::size_t i = 0; i < held.size(); ++i) mass += held[i] ? 0.0 : scene.particles.mass[i];
  return mass * gravity_of(scene).norm();
}

double largest_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

double kinetic_energy(const Scene& scene, const std::vector<Vec3>& velocities) {
  const std::vector<bool> held = pinned(scene);
  double sum = 0.0;
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (!held[i]) sum += 0.5 * scene.particles.mass[i] * velocities[i].squaredNorm();
  }
  return sum;
}

}  // namespace hooke::hard
