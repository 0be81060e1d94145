#pragma once

#include <Eigen/Geometry>

#include "collide/triangle_tree.h"

namespace hooke {

/// Six times the volume of a tetrahedron [m^3]; positive where d is on the side of abc that its corners are
/// seen clockwise from.
inline double orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (a - d).dot((b - d).cross(c - d));
}

/// Whether the line between two points goes through the inside of a triangle. What only touches, up to
/// rounding, does not.
inline bool crosses(const Vec3& p, const Vec3& q, const TriangleCorners& t) {
  const double before = orientation(t[0], t[1], t[2], p), after = orientation(t[0], t[1], t[2], q);
  if (!(before * after < 0.0)) return false;
  const double ab = orientation(p, q, t[0], t[1]), bc = orientation(p, q, t[1], t[2]),
               ca = orientation(p, q, t[2], t[0]);
  return (ab > 0.0 && bc > 0.0 && ca > 0.0) || (ab < 0.0 && bc < 0.0 && ca < 0.0);
}

}  // namespace hooke
