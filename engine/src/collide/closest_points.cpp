#include "collide/closest_points.h"

#include <algorithm>

namespace hooke {
namespace {

/// A point of a triangle by the weights of its second and third corner.
ClosestPoints corner_to(const PairPlaces& x, double v, double w) {
  const std::array<double, 4> weights{1.0, -(1.0 - v - w), -v, -w};
  return {weights, (x[0] - x[1]) - v * (x[2] - x[1]) - w * (x[3] - x[1])};
}

double share(double part, double whole) {
  return whole > 0.0 ? std::clamp(part / whole, 0.0, 1.0) : 0.0;
}

/// For a point that lies beside the triangle, or one of no area: the nearest of its sides' points.
ClosestPoints corner_to_sides(const PairPlaces& x) {
  const Vec3 ab = x[2] - x[1], ac = x[3] - x[1], bc = x[3] - x[2];
  const double on_bc = share((x[0] - x[2]).dot(bc), bc.squaredNorm());
  const ClosestPoints sides[] = {corner_to(x, share((x[0] - x[1]).dot(ab), ab.squaredNorm()), 0.0),
                                 corner_to(x, 0.0, share((x[0] - x[1]).dot(ac), ac.squaredNorm())),
                                 corner_to(x, 1.0 - on_bc, on_bc)};
  return *std::min_element(std::begin(sides), std::end(sides),
                           [](const ClosestPoints& a, const ClosestPoints& b) {
                             return a.between.squaredNorm() < b.between.squaredNorm();
                           });
}

}  // namespace

ClosestPoints closest_corner_triangle(const PairPlaces& x) {
  const Vec3 ab = x[2] - x[1], ac = x[3] - x[1], ap = x[0] - x[1];
  const double bb = ab.squaredNorm(), bc = ab.dot(ac), cc = ac.squaredNorm();
  const double pb = ap.dot(ab), pc = ap.dot(ac);
  const double area = bb * cc - bc * bc;  // squared, times four
  const double v = cc * pb - bc * pc, w = bb * pc - bc * pb;
  const bool above = area > 1e-14 * bb * cc && v > 0.0 && w > 0.0 && v + w < area;
  return above ? corner_to(x, v / area, w / area) : corner_to_sides(x);
}

ClosestPoints closest_edges(const PairPlaces& x) {
  const Vec3 along = x[1] - x[0], other = x[3] - x[2], apart = x[0] - x[2];
  const double a = along.squaredNorm(), e = other.squaredNorm(), b = along.dot(other);
  const double c = along.dot(apart), f = other.dot(apart);
  const double across = a * e - b * b;  // squared, zero where parallel
  double s = across > 1e-14 * a * e ? std::clamp((b * f - c * e) / across, 0.0, 1.0) : 0.0;
  const double t = share(b * s + f, e);
  s = share(b * t - c, a);
  return {{1.0 - s, s, -(1.0 - t), -t}, apart + s * along - t * other};
}

}  // namespace hooke
