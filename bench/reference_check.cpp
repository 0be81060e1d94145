#include "reference_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

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

double ReferenceCheck::distance(const std::vector<Vec3>& positions) const {
  return largest_distance(positions, expected_);
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
  const double reached = distance(positions_of(simulation));
  simulation.restore(before);
  return ok ? reached : std::numeric_limits<double>::infinity();
}

template double ReferenceCheck::distance(Simulation<float>&) const;
template double ReferenceCheck::distance(Simulation<double>&) const;

Scene CheckedScene::start_of_check() const {
  Scene scene = bench.scene;
  scene.particles.position = check.start();
  return scene;
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

}  // namespace hooke::bench
