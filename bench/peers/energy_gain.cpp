#include "energy_gain.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "scene/number_text.h"

namespace hooke::bench {
namespace {

/// [J]
double kinetic_energy(const Particles& particles) {
  double energy = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i)
    energy += 0.5 * particles.mass[i] * particles.velocity_of(i).squaredNorm();
  return energy;
}

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

void require_no_gain(const Scene& scene, const std::vector<Vec3>& positions) {
  const double elastic = elastic_energy(scene.springs, positions);
  const double at_start =
      kinetic_energy(scene.particles) + elastic_energy(scene.springs, scene.particles.position);
  const double gain = elastic + gravitational_energy(scene, positions) - at_start;
  // Symplectic Euler lets energy swing a little about what it should be.
  if (!(gain <= 0.01 * elastic)) throw std::runtime_error("gained " + to_text(gain) + " J from nothing");
}

}  // namespace hooke::bench
