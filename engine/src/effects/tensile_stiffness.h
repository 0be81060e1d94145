#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

#include <hooke/effects.h>

/// One triangle of TensileTriangles.

namespace hooke {

using Corners = std::array<Vec3, 3>;

/// The side opposite corner i.
inline Vec3 side_of(const Corners& x, std::size_t i) {
  return x[(i + 2) % 3] - x[(i + 1) % 3];
}

/// Twice the area [m^2].
double doubled_area(const Corners& x);

/// The stiffness C of a triangle: with q_i = l_i^2 - L_i^2 of its sides its energy is q^T C q / 4, so that C
/// has k_i on its diagonal and c_ij beside it: C = b b^T + s (2 I - 1), where b_i = cot a_i sqrt(2 p / 16A),
/// s = m / 16A and 1 is all ones.
struct TensileStiffness {
  double s;  ///< [N/m^3]
  Vec3 b;    ///< [sqrt(N/m^3)]

  Eigen::Matrix3d matrix() const;

  /// The largest eigenvalue [N/m] of the derivative of the forces on the corners, as they are at rest.
  double largest_at_rest(const Corners& x) const;
};

/// Of a triangle that is at rest so; it must have an area.
TensileStiffness stiffness_of(const TensileTriangles& sheet, const Corners& rest);

/// A triangle as it lies now.
struct StrainedTriangle {
  Corners x;
  TensileStiffness stiffness;
  Vec3 stretch;  ///< l^2 - L^2 of each side
};

/// The derivative of the force on a corner by its own place, without what makes it indefinite: `stretching`
/// times what the sides' lengths do to their tensions, `turning` times what pulls as the sides turn.
Eigen::Matrix3d own_derivative(const StrainedTriangle& triangle, std::size_t corner, double stretching,
                               double turning);

}  // namespace hooke
