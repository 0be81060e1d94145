#include "checked_scene.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "naive_cloth.h"

namespace hooke::bench {
namespace {

/// [J]
double elastic_energy(const Springs& springs, const std::vector<Vec3>& positions) {
  double energy = 0.0;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const double length = (positions[springs.second[s]] - positions[springs.first[s]]).norm();
    energy += 0.5 * springs.stiffness[s] * std::pow(length - springs.rest_length[s], 2);
  }
  return energy;
}

/// Of gravity [J], against the start.
double gravitational_energy(const Scene& scene, const std::vector<Vec3>& positions) {
  double energy = 0.0;
  for (const Effect& effect : scene.effects) {
    if (const auto* gravity = std::get_if<Gravity>(&effect)) {
      for (std::size_t i = 0; i < positions.size(); ++i) {
        const Vec3 way = positions[i] - scene.particles.position[i];
        energy -= scene.particles.mass[i] * gravity->acceleration.dot(way);
      }
    }
  }
  return energy;
}

}  // namespace

CheckedScene::CheckedScene(BenchScene given) : bench(std::move(given)) {
  NaiveCloth reference(bench.scene, bench.step);
  for (int i = 0; i < checked_steps; ++i) reference.step();
  for (std::size_t i = 0; i < reference.particles(); ++i) expected.push_back(reference.position(i));
}

double largest_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double distance = (a[i] - b[i]).norm();
    if (!std::isfinite(distance)) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, distance);
  }
  return largest;
}

void require_near(const std::vector<Vec3>& positions, const CheckedScene& scene, double tolerance) {
  const double distance = largest_distance(positions, scene.expected);
  if (!(distance <= tolerance)) {
    throw std::runtime_error("differs from the reference by " + std::to_string(distance) +
                             " m, which is more than round-off");
  }
}

void require_no_gain(const std::vector<Vec3>& positions, const CheckedScene& scene) {
  const Scene& s = scene.bench.scene;
  const double elastic = elastic_energy(s.springs, positions);
  const double gain =
      elastic + gravitational_energy(s, positions) - elastic_energy(s.springs, s.particles.position);
  // Symplectic Euler lets energy swing a little about what it should be.
  if (!(gain <= 0.01 * elastic))
    throw std::runtime_error("gained " + std::to_string(gain) + " J from nothing while it was timed");
}

}  // namespace hooke::bench
