#include "moving_network.h"

#include <cmath>
#include <numbers>
#include <numeric>

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

Scene moving_network(const Scene& scene, double step) {
  Scene network = scene;
  network.effects.clear();
  const std::vector<double>& lengths = network.springs.rest_length;
  const double length = std::accumulate(lengths.begin(), lengths.end(), 0.0) / double(lengths.size());
  const double speed = 0.005 * length / step, wave_number = 2.0 * std::numbers::pi / (16.0 * length);
  network.particles.velocity.clear();
  for (const Vec3& position : network.particles.position) {
    const double a = wave_number * position.dot(Vec3(1.0, 0.4, 0.7));
    const double b = wave_number * position.dot(Vec3(-0.3, 1.0, 0.8));
    network.particles.velocity.push_back(speed * Vec3(std::sin(a), std::cos(b), std::sin(a + b)));
  }
  for (const Pin& pin : network.pins) network.particles.velocity[pin.particle].setZero();
  return network;
}

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

Scene half_kick_earlier(const Scene& network, double step) {
  Scene earlier = network;
  const std::vector<Vec3> start = accelerations(network, network.particles.position);
  for (std::size_t i = 0; i < start.size(); ++i) earlier.particles.velocity[i] -= 0.5 * step * start[i];
  return earlier;
}

}  // namespace hooke::bench
