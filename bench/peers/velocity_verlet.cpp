#include "velocity_verlet.h"

namespace hooke::bench {
namespace {

/// The acceleration [m/s^2] of every particle by its springs; zero where it is pinned.
std::vector<Vec3> accelerations(const Scene& network, const std::vector<Vec3>& positions) {
  std::vector<Vec3> result(positions.size(), Vec3::Zero());
  const Springs& springs = network.springs;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const Index a = springs.first[s], b = springs.second[s];
    const Vec3 span = positions[b] - positions[a];
    const double length = span.norm();
    const Vec3 pull = springs.stiffness[s] * (length - springs.rest_length[s]) / length * span;
    result[a] += pull / network.particles.mass[a];
    result[b] -= pull / network.particles.mass[b];
  }
  for (const Pin& pin : network.pins) result[pin.particle].setZero();
  return result;
}

}  // namespace

std::vector<Vec3> velocity_verlet(const Scene& network, double step, int steps) {
  std::vector<Vec3> positions = network.particles.position, velocities = network.particles.velocity;
  std::vector<Vec3> before = accelerations(network, positions);
  for (int n = 0; n < steps; ++n) {
    for (std::size_t i = 0; i < positions.size(); ++i)
      positions[i] += step * (velocities[i] + 0.5 * step * before[i]);
    const std::vector<Vec3> after = accelerations(network, positions);
    for (std::size_t i = 0; i < positions.size(); ++i) velocities[i] += 0.5 * step * (before[i] + after[i]);
    before = after;
  }
  return positions;
}

}  // namespace hooke::bench
