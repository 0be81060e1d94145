#pragma once

#include <array>
#include <utility>
#include <vector>

#include <hooke/executor.h>

#include "collide/box_tree.h"
#include "collide/close_pairs.h"

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

  /// Looks which edges and triangles have boxes that meet; only those are tested, until the next look. Where
  /// boxes are around one place of each, `at`, what is further apart there than `distance` [m] is left out.
  void look(const BoxTree& edges, const BoxTree& triangles, const Places* at, double distance,
            Executor& executor);

  /// Whether there is nothing to test.
  bool none_near() const { return near_.empty(); }

  /// All crossings, sorted by edge and triangle; the same on any number of threads. Valid until the next
  /// call.
  const std::vector<Crossing>& find(const Places& places, Executor& executor);

  std::size_t bytes() const;

 private:
  using EdgeAndTriangle = std::pair<Index, Index>;

  /// What one group of edges is near.
  struct NearRun {
    std::vector<std::size_t> groups;
    std::vector<EdgeAndTriangle> near;
  };

  const Surface& surface_;
  std::vector<EdgeAndTriangle> near_;
  std::vector<NearRun> near_runs_;
  std::vector<std::vector<Crossing>> found_runs_;
  std::vector<Crossing> found_;
};

}  // namespace hooke
