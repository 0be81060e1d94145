#include "collide/solid_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hooke {
namespace {

/// As far as rounding of positions may hide that boxes meet.
template <class Real>
constexpr double rounding = 8.0 * double(std::numeric_limits<Real>::epsilon());

/// A solid stands still that moves by no more than this share of its distance from the origin: between two
/// keyframes that are equal, rounding moves it.
constexpr double same_pose = 1e-14;

/// Infinite, but where the plane is across an axis, as floors and walls are: there it ends at the surface, so
/// that what is clear of it is known from boxes alone.
template <class Real>
Bounds<Real> bounds_of_plane(const PlaneShape& plane, double thickness, const FramePlace& place) {
  constexpr Real infinite = std::numeric_limits<Real>::infinity();
  Bounds<Real> bounds{{-infinite, -infinite, -infinite}, {infinite, infinite, infinite}};
  const Vec3 normal = place.rotation * plane.normal.normalized();
  const double surface = normal.dot(place.origin) + plane.height + thickness;
  const double size = 2.0 * std::abs(surface) + std::abs(plane.height) + thickness;
  const Real end = Real(surface + rounding<Real> * size);
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (normal[k] == 1.0) bounds.high[k] = end;
    if (normal[k] == -1.0) bounds.low[k] = -end;
  }
  return bounds;
}

}  // namespace

template <class Real>
Bounds<Real> bounds_at(const Collider& collider, const FramePlace& place) {
  if (const auto* plane = std::get_if<PlaneShape>(&collider.shape))
    return bounds_of_plane<Real>(*plane, collider.thickness, place);
  const Vec3 half =
      place.rotation.cwiseAbs() * half_extent_of(collider.shape) + Vec3::Constant(collider.thickness);
  Bounds<Real> bounds;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double slack = rounding<Real> * (std::abs(place.origin[k]) + half[k]);
    bounds.low[k] = Real(place.origin[k] - half[k] - slack);
    bounds.high[k] = Real(place.origin[k] + half[k] + slack);
  }
  return bounds;
}

template <class Real>
bool is_clear_of(const LocalShape<Real>& shape, const Pose<Real>& pose, Real thickness,
                 const Bounds<Real>& box) {
  const auto* plane = std::get_if<LocalPlane<Real>>(&shape);
  if (plane == nullptr) return false;
  const Real local[] = {plane->nx, plane->ny, plane->nz};
  Real lowest = -plane->height - thickness, size = std::abs(plane->height);
  for (std::size_t k = 0; k < 3; ++k) {
    Real n = Real(0);
    for (std::size_t j = 0; j < 3; ++j) n += pose.rotation[k][j] * local[j];
    const Real low = n * (box.low[k] - pose.origin[k]);
    const Real high = n * (box.high[k] - pose.origin[k]);
    lowest += std::min(low, high);
    size += std::max(std::abs(low), std::abs(high));
  }
  return lowest > Real(rounding<Real>) * size;
}

void disturb_near(const RigidMotion& motion, const Vec3& half, double from, double to,
                  Disturbances& disturbed) {
  const FramePlace before = motion.at(from), after = motion.at(to);
  const bool turns = !before.rotation.isApprox(after.rotation, same_pose);
  if (!turns && before.origin.isApprox(after.origin, same_pose)) return;
  // Turned by any angle, or of a plane.
  const bool anywhere = turns || !half.allFinite();
  const Vec3 extent = anywhere ? Vec3(Vec3::Constant(half.norm())) : Vec3(before.rotation.cwiseAbs() * half);
  disturbed.box(before.origin.cwiseMin(after.origin) - extent, before.origin.cwiseMax(after.origin) + extent);
}

template <class Real>
bool may_meet(const Vec3& from, const Vec3& to, double reach, const Bounds<Real>& box) {
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (std::min(from[k], to[k]) - reach > double(box.high[k])) return false;
    if (std::max(from[k], to[k]) + reach < double(box.low[k])) return false;
  }
  return true;
}

template Bounds<float> bounds_at(const Collider&, const FramePlace&);
template Bounds<double> bounds_at(const Collider&, const FramePlace&);
template bool is_clear_of(const LocalShape<float>&, const Pose<float>&, float, const Bounds<float>&);
template bool is_clear_of(const LocalShape<double>&, const Pose<double>&, double, const Bounds<double>&);
template bool may_meet(const Vec3&, const Vec3&, double, const Bounds<float>&);
template bool may_meet(const Vec3&, const Vec3&, double, const Bounds<double>&);

}  // namespace hooke
