#pragma once

#include <limits>
#include <vector>

#include "bench_scenes.h"

namespace hooke::bench {

/// The steps that every run takes before it is timed, and after which its positions are compared.
constexpr int checked_steps = 10;

/// The scenes are 1 m in size: round-off [m] of a position, for each checked step.
template <class Real>
constexpr double round_off = checked_steps* double(std::numeric_limits<Real>::epsilon());

/// A scene with waves of velocity in it, and where its particles are after the checked steps of a serial
/// double reference. The waves strain the springs by some per cent in these steps: from rest, all would fall
/// freely, and wrong springs would go unseen.
struct CheckedScene {
  BenchScene bench;
  std::vector<Vec3> expected;  ///< [m]

  explicit CheckedScene(BenchScene given);
};

/// The largest distance [m] between particles of the same number; infinite if one is not finite.
double largest_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

/// Throws std::runtime_error where `positions` are further than `tolerance` [m] from what the scene expects.
void require_near(const std::vector<Vec3>& positions, const CheckedScene& scene, double tolerance);

}  // namespace hooke::bench
