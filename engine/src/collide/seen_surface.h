#pragma once

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

namespace hooke {

/// The surface of a solid as a point sees it: as a plane, at least at this point.
template <class Real>
struct SeenSurface {
  using Vector = Eigen::Matrix<Real, 3, 1>;

  Vector outwards;    ///< unit vector away from the nearest point, out of the solid
  Real offset;        ///< the point's distance is outwards . point - offset [m], negative inside
  Real holds_within;  ///< radius around the point in which all points see this plane [m]; 0: none else

  Real distance(const Vector& point) const { return outwards.dot(point) - offset; }
};

/// A surface of which no more is told than that it is at least so far away, which is no less than `reach`; so
/// it is half of the way there.
template <class Real>
SeenSurface<Real> seen_far_away(Real at_least, Real reach) {
  const Real within = std::max(Real(0.5) * (at_least - reach), Real(0));
  return {Eigen::Matrix<Real, 3, 1>::Zero(), within - at_least, within};
}

/// From the nearest point, which lies on an edge or a corner, whose normal is some direction out of the
/// solid; side: 1 outside, -1 inside.
template <class Real>
SeenSurface<Real> seen_from_edge(const Eigen::Matrix<Real, 3, 1>& nearest,
                                 const Eigen::Matrix<Real, 3, 1>& normal, Real side,
                                 const Eigen::Matrix<Real, 3, 1>& point) {
  const Eigen::Matrix<Real, 3, 1> away = point - nearest;
  const Real length = away.norm();
  // So near that rounding decides the direction of `away`: the normal is as good.
  constexpr Real noise = Real(16) * std::numeric_limits<Real>::epsilon();
  const bool is_noise = length <= noise * point.cwiseAbs().maxCoeff();
  const Eigen::Matrix<Real, 3, 1> outwards = is_noise ? normal : away * (side / length);
  return {outwards, outwards.dot(nearest), Real(0)};
}

}  // namespace hooke
