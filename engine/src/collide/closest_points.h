#pragma once

#include <array>

#include <hooke/vec3.h>

namespace hooke {

/// Two pieces of a surface that share no particle, by four: a corner (the first) and a triangle, or two edges
/// (the first two, and the last two).
enum class PairKind : unsigned char { corner_triangle, edge_edge };

/// Places [m] of the four particles of a pair.
using PairPlaces = std::array<Vec3, 4>;

/// The points of the two pieces that are nearest to each other, as weights of the four particles: those of
/// the first piece sum to 1, those of the second to -1, so that `between` = sum of weight times place.
struct ClosestPoints {
  std::array<double, 4> weights;
  Vec3 between;  ///< from the second piece's point to the first one's [m]

  double distance() const { return between.norm(); }
};

/// Of a point and a triangle, which may be degenerate (Ericson 2005, "Real-Time Collision Detection", 5.1.5).
ClosestPoints closest_corner_triangle(const PairPlaces& x);

/// Of two segments, which may be parallel or points (Ericson 2005, 5.1.9).
ClosestPoints closest_edges(const PairPlaces& x);

inline ClosestPoints closest_points(PairKind kind, const PairPlaces& x) {
  return kind == PairKind::corner_triangle ? closest_corner_triangle(x) : closest_edges(x);
}

}  // namespace hooke
