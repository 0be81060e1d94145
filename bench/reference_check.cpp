#include "reference_check.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

#include "naive_cloth.h"

namespace hooke::bench {
namespace {

/// Uniform in [-1, 1).
double jitter(std::mt19937& random) {
  return double(random()) * 0x1p-31 - 1.0;
}

/// The scene's positions, each moved by up to a tenth of its particle's shortest spring. Values that a float
/// holds, so that both precisions start from the same place.
std::vector<Vec3> disturbed_positions(const Scene& scene) {
  std::vector<double> shortest(scene.particles.size(), std::numeric_limits<double>::max());
  for (std::size_t s = 0; s < scene.springs.size(); ++s) {
    for (Index end : {scene.springs.first[s], scene.springs.second[s]})
      shortest[end] = std::min(shortest[end], scene.springs.rest_length[s]);
  }
  std::mt19937 random(1);
  std::vector<Vec3> positions = scene.particles.position;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double most = 0.1 * (shortest[i] < std::numeric_limits<double>::max() ? shortest[i] : 0.0);
    for (int axis = 0; axis < 3; ++axis)
      positions[i][axis] = double(float(positions[i][axis] + most * jitter(random)));
  }
  return positions;
}

}  // namespace

ReferenceCheck::ReferenceCheck(BenchScene& bench)
    : start_(disturbed_positions(bench.scene)),
      stiffness_sum_(
          std::accumulate(bench.scene.springs.stiffness.begin(), bench.scene.springs.stiffness.end(), 0.0)) {
  bench.scene.particles.position.swap(start_);
  NaiveCloth reference(bench.scene, bench.step);
  bench.scene.particles.position.swap(start_);
  for (int i = 0; i < steps; ++i) reference.step();
  expected_.reserve(reference.particles());
  for (std::size_t i = 0; i < reference.particles(); ++i) expected_.push_back(reference.position(i));
}

template <class Real>
double ReferenceCheck::distance(Simulation<Real>& simulation) const {
  const Snapshot<Real> before = simulation.snapshot();
  Snapshot<Real> start = before;
  for (std::size_t i = 0; i < start_.size(); ++i) {
    Eigen::Map<Eigen::Matrix<Real, 3, 1>>(&start.positions[3 * i]) = start_[i].cast<Real>();
  }
  std::fill(start.velocities.begin(), start.velocities.end(), Real(0));
  simulation.restore(start);
  const bool ok = simulation.step(steps).ok();
  const std::vector<Real> reached = simulation.snapshot().positions;
  simulation.restore(before);

  double worst = ok ? 0.0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < expected_.size(); ++i) {
    const Vec3 position =
        Eigen::Map<const Eigen::Matrix<Real, 3, 1>>(&reached[3 * i]).template cast<double>();
    worst = std::max(worst, (position - expected_[i]).norm());
  }
  return worst;
}

template double ReferenceCheck::distance(Simulation<float>&) const;
template double ReferenceCheck::distance(Simulation<double>&) const;

}  // namespace hooke::bench
