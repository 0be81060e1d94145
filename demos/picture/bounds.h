#pragma once

#include <array>
#include <span>

#include <Eigen/Core>

namespace hooke::picture {

/// The box around some points.
struct Bounds {
  Eigen::Vector3f least = Eigen::Vector3f::Zero(), most = Eigen::Vector3f::Zero();  ///< [m]
  bool all_finite = true;  ///< where not, the box is around those points that are

  Eigen::Vector3d centre() const { return 0.5 * (least.cast<double>() + most.cast<double>()); }
  /// [m] from corner to corner.
  double diagonal() const { return (most.cast<double>() - least.cast<double>()).norm(); }
  std::array<Eigen::Vector3d, 8> corners() const;
};

/// Of points as x, y, z of each [m].
Bounds bounds_of(std::span<const float> points);

}  // namespace hooke::picture
