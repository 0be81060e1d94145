#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <variant>
#include <vector>

#include "scene_file/scene_file.h"

namespace hooke::test {

/// An upper bound of the largest eigenvalue of M^-1 (h^2 K + 2 h C) for a scene and a step h [s]: K the
/// stiffness and C the damping of springs, drag and ground, pinned particles of infinite mass. Symplectic
/// Euler is stable where this is below 4: a mode obeys R^2 - (2 - h^2 k - h c) R + (1 - h c) = 0, whose roots
/// stay in the unit circle as long as h^2 k + 2 h c < 4 (with the usual k = w^2, c = 2 zeta w).
/// The bound is Gershgorin's on edges: the largest, over springs, of the sum over both ends of what pulls at
/// an end divided by its mass.
inline double stability_number(const Scene& scene, double step) {
  const Springs& springs = scene.springs;
  const auto weight = [&](double stiffness, double damping) {
    return step * step * stiffness + 2.0 * step * damping;
  };
  std::vector<double> pull(scene.particles.size(), 0.0);
  for (std::size_t s = 0; s < springs.size(); ++s) {
    pull[springs.first[s]] += weight(springs.stiffness[s], springs.damping_of(s));
    pull[springs.second[s]] += weight(springs.stiffness[s], springs.damping_of(s));
  }
  double on_each = 0.0;
  for (const Effect& effect : scene.effects) {
    if (const auto* drag = std::get_if<Drag>(&effect)) on_each += weight(0.0, drag->coefficient);
    if (const auto* ground = std::get_if<GroundPlane>(&effect))
      on_each += weight(ground->stiffness, ground->damping);
  }
  std::vector<double> mass = scene.particles.mass;
  for (const Pin& pin : scene.pins) mass[pin.particle] = std::numeric_limits<double>::infinity();

  double largest = 0.0, largest_alone = 0.0;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const Index i = springs.first[s], j = springs.second[s];
    largest = std::max(largest, pull[i] / mass[i] + pull[j] / mass[j]);
  }
  for (const double m : mass) largest_alone = std::max(largest_alone, on_each / m);
  return largest + largest_alone;
}

}  // namespace hooke::test
