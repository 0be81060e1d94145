#pragma once

#include <Eigen/Core>

namespace hooke {

/// The part of a triangle abc that a nearest point lies on. Edges are named by the corner that they begin at:
/// ab, bc, ca.
enum class TrianglePart : unsigned char { face, edge_a, edge_b, edge_c, corner_a, corner_b, corner_c };

template <class Real>
struct ClosestOnTriangle {
  Eigen::Matrix<Real, 3, 1> point;
  TrianglePart part;
};

/// The point of a triangle that is nearest to p (Ericson, "Real-Time Collision Detection", 2005, 5.1.5). A
/// triangle without an area is the lines between its corners.
template <class Real>
ClosestOnTriangle<Real> closest_on_triangle(const Eigen::Matrix<Real, 3, 1>& p,
                                            const Eigen::Matrix<Real, 3, 1>& a,
                                            const Eigen::Matrix<Real, 3, 1>& b,
                                            const Eigen::Matrix<Real, 3, 1>& c) {
  using Vector = Eigen::Matrix<Real, 3, 1>;
  const Vector ab = b - a, ac = c - a, ap = p - a;
  const Real d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {a, TrianglePart::corner_a};
  const Vector bp = p - b;
  const Real d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {b, TrianglePart::corner_b};
  const Real beside_ab = d1 * d4 - d3 * d2;
  if (beside_ab <= 0 && d1 >= 0 && d3 <= 0 && d1 > d3) return {a + d1 / (d1 - d3) * ab, TrianglePart::edge_a};
  const Vector cp = p - c;
  const Real d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {c, TrianglePart::corner_c};
  const Real beside_ac = d5 * d2 - d1 * d6;
  if (beside_ac <= 0 && d2 >= 0 && d6 <= 0 && d2 > d6) return {a + d2 / (d2 - d6) * ac, TrianglePart::edge_c};
  const Real beside_bc = d3 * d6 - d5 * d4;
  const Real along = d4 - d3, back = d5 - d6;
  if (beside_bc <= 0 && along >= 0 && back >= 0 && along + back > 0)
    return {b + along / (along + back) * (c - b), TrianglePart::edge_b};
  const Real scale = Real(1) / (beside_ab + beside_ac + beside_bc);
  return {a + ab * (beside_ac * scale) + ac * (beside_ab * scale), TrianglePart::face};
}

}  // namespace hooke
