#pragma once

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench_scenes.h"
#include "naive_cloth.h"

namespace hooke::bench {

/// The steps that every run takes before it is timed, and after which its positions are compared.
constexpr int checked_steps = 10;

/// The scenes are 1 m in size: round-off [m] of a position, for each checked step.
template <class Real>
constexpr double round_off = 4.0 * checked_steps* double(std::numeric_limits<Real>::epsilon());

/// A scene and where its particles are after the checked steps of a serial double reference.
struct CheckedScene {
  BenchScene bench;
  std::vector<Vec3> expected;  ///< [m]

  explicit CheckedScene(BenchScene given) : bench(std::move(given)) {
    NaiveCloth reference(bench.scene, bench.step);
    for (int i = 0; i < checked_steps; ++i) reference.step();
    for (std::size_t i = 0; i < reference.particles(); ++i) expected.push_back(reference.position(i));
  }
};

/// The largest distance [m] between particles of the same number; infinite if one is not finite.
inline double largest_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double distance = (a[i] - b[i]).norm();
    if (!std::isfinite(distance)) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, distance);
  }
  return largest;
}

/// Throws where `positions` are further than `tolerance` [m] from `expected`.
inline void require_near(const std::vector<Vec3>& positions, const std::vector<Vec3>& expected,
                         double tolerance) {
  const double distance = largest_distance(positions, expected);
  if (!(distance <= tolerance)) {
    throw std::runtime_error("differs from the reference by " + std::to_string(distance) +
                             " m, more than the " + std::to_string(tolerance) + " m of round-off");
  }
}

/// Throws where a run exploded while it was timed. A timed run lasts a fraction of a second of simulated
/// time, in which nothing moves as far as the size of the scene; an explosion passes it within a few steps.
inline void require_whole(const std::vector<Vec3>& positions, const CheckedScene& scene) {
  if (!(largest_distance(positions, scene.expected) <= 1.0))
    throw std::runtime_error("exploded while it was timed");
}

}  // namespace hooke::bench
