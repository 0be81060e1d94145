#include "picture/bounds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace hooke::picture {
namespace {

constexpr float most_float = std::numeric_limits<float>::max();

/// The box around those points all of whose coordinates are finite.
Bounds bounds_of_finite(std::span<const float> points) {
  Bounds bounds{.least = Eigen::Vector3f::Constant(most_float),
                .most = Eigen::Vector3f::Constant(-most_float),
                .all_finite = false};
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    const Eigen::Vector3f point(points[i], points[i + 1], points[i + 2]);
    if (!point.allFinite()) continue;
    bounds.least = bounds.least.cwiseMin(point);
    bounds.most = bounds.most.cwiseMax(point);
  }
  if (bounds.least.x() > bounds.most.x()) bounds.least = bounds.most = Eigen::Vector3f::Zero();
  return bounds;
}

}  // namespace

std::array<Eigen::Vector3d, 8> Bounds::corners() const {
  std::array<Eigen::Vector3d, 8> corners;
  for (std::size_t k = 0; k < 8; ++k) {
    corners[k] = {double((k & 1 ? most : least).x()), double((k & 2 ? most : least).y()),
                  double((k & 4 ? most : least).z())};
  }
  return corners;
}

Bounds bounds_of(std::span<const float> points) {
  // Four points at once, in lanes that the compiler makes vectors of.
  constexpr std::size_t lanes = 12;
  if (points.size() < 3) return {};
  std::array<float, lanes> least, most, residue{};
  for (std::size_t k = 0; k < lanes; ++k) least[k] = most[k] = points[k % 3];
  std::size_t i = 0;
  for (; i + lanes <= points.size(); i += lanes) {
    for (std::size_t k = 0; k < lanes; ++k) {
      const float value = points[i + k];
      least[k] = value < least[k] ? value : least[k];
      most[k] = value > most[k] ? value : most[k];
      residue[k] += value - value;  // 0, or not a number where the value is not finite
    }
  }
  for (; i < points.size(); ++i) {
    least[i % 3] = std::min(least[i % 3], points[i]);
    most[i % 3] = std::max(most[i % 3], points[i]);
    residue[i % 3] += points[i] - points[i];
  }
  Bounds bounds;
  for (std::size_t k = 0; k < lanes; ++k) {
    if (!(residue[k] == 0.0f)) return bounds_of_finite(points);
    const auto axis = Eigen::Index(k % 3);
    bounds.least[axis] = k < 3 ? least[k] : std::min(bounds.least[axis], least[k]);
    bounds.most[axis] = k < 3 ? most[k] : std::max(bounds.most[axis], most[k]);
  }
  return bounds;
}

}  // namespace hooke::picture
