#pragma once

#include <array>
#include <utility>
#include <vector>

#include <hooke/executor.h>

#include "collide/close_pairs.h"
#include "collide/hash_grid.h"

namespace hooke {

/// An edge that goes through a triangle that it shares no particle with.
struct Crossing {
  Index edge, triangle;           ///< numbers in the surface
  double along;                   ///< where on the edge, from 0 at its first end to 1
  std::array<double, 3> weights;  ///< of the triangle's corners, there; they sum to 1
};

/// Finds where a surface crosses itself. What lies in the plane of a triangle, up to rounding, counts as in
/// front of it, and what meets an edge passes it on the same side for both of its triangles: so curves of
/// crossings have no gaps.
class Crossings {
 public:
  explicit Crossings(const Surface& surface) : surface_(surface) {}

  /// Looks which edges and triangles get within `reach` [m] of each other on straight ways from `start` to
  /// `end`, which may be one; only those are tested, until the next look.
  void look(const Places& start, const Places& end, double reach, Executor& executor);

  /// Whether there is nothing to test.
  bool none_near() const { return near_.empty(); }

  /// All crossings, sorted by edge and triangle; the same on any number of threads. Valid until the next
  /// call.
  const std::vector<Crossing>& find(const Places& places, Executor& executor);

  std::size_t bytes() const;

 private:
  using EdgeAndTriangle = std::pair<Index, Index>;

  const Surface& surface_;
  std::vector<AxisBox> boxes_;
  HashGrid triangles_;
  std::vector<EdgeAndTriangle> near_;
  std::vector<std::vector<EdgeAndTriangle>> near_runs_;
  std::vector<std::vector<Crossing>> found_runs_;
  std::vector<Crossing> found_;
};

}  // namespace hooke
