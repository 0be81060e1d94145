#include "checked_scene.h"

#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>

#include "naive_cloth.h"
#include "scene/number_text.h"

namespace hooke::bench {
namespace {

/// Velocities [m/s] of which each takes a particle a hundredth of a spring's length in a step, in waves that
/// are 16 springs long; zero where a particle is pinned.
std::vector<Vec3> waves(const Scene& scene, double step) {
  const std::vector<double>& lengths = scene.springs.rest_length;
  const double length = std::accumulate(lengths.begin(), lengths.end(), 0.0) / double(lengths.size());
  const double speed = 0.01 * length / step, wave_number = 2.0 * std::numbers::pi / (16.0 * length);
  std::vector<Vec3> velocities;
  for (const Vec3& position : scene.particles.position) {
    const double a = wave_number * position.dot(Vec3(1.0, 0.4, 0.7));
    const double b = wave_number * position.dot(Vec3(-0.3, 1.0, 0.8));
    velocities.push_back(speed * Vec3(std::sin(a), std::cos(b), std::sin(a + b)));
  }
  for (const Pin& pin : scene.pins) velocities[pin.particle].setZero();
  return velocities;
}

}  // namespace

CheckedScene::CheckedScene(BenchScene given) : bench(std::move(given)) {
  bench.scene.particles.velocity = waves(bench.scene, bench.step);
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
    throw std::runtime_error("differs from the reference by " + to_text(distance) +
                             " m, which is more than round-off");
  }
}

}  // namespace hooke::bench
