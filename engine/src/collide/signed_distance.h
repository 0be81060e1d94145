#pragma once

#include <limits>

#include <Eigen/Geometry>

namespace hooke {

/// A point as a solid's surface sees it.
template <class Real>
struct SignedDistance {
  Real distance;                       ///< [m], negative inside
  Eigen::Matrix<Real, 3, 1> outwards;  ///< unit vector away from the nearest point, out of the solid
};

/// From the nearest point of the surface, which lies on a face with this normal, out of the solid.
template <class Real>
SignedDistance<Real> seen_from_face(const Eigen::Matrix<Real, 3, 1>& nearest,
                                    const Eigen::Matrix<Real, 3, 1>& normal,
                                    const Eigen::Matrix<Real, 3, 1>& point) {
  return {normal.dot(point - nearest), normal};
}

/// Likewise where it lies on an edge or a corner, whose normal is some direction out of the solid; side: 1
/// outside, -1 inside.
template <class Real>
SignedDistance<Real> seen_from_edge(const Eigen::Matrix<Real, 3, 1>& nearest,
                                    const Eigen::Matrix<Real, 3, 1>& normal, Real side,
                                    const Eigen::Matrix<Real, 3, 1>& point) {
  const Eigen::Matrix<Real, 3, 1> away = point - nearest;
  const Real length = away.norm();
  // So near that rounding decides the direction of `away`.
  constexpr Real noise = Real(16) * std::numeric_limits<Real>::epsilon();
  if (length <= noise * point.cwiseAbs().maxCoeff()) return {side * length, normal};
  return {side * length, away * (side / length)};
}

}  // namespace hooke
