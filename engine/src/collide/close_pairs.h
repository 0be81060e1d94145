#pragma once

#include <array>
#include <vector>

#include <hooke/executor.h>
#include <hooke/scene.h>

#include "collide/closest_points.h"
#include "collide/hash_grid.h"
#include "scene/mesh_edges.h"

namespace hooke {

/// A corner and a triangle, or two edges, that may touch.
struct ClosePair {
  std::array<Index, 4> particles;  ///< as in PairPlaces
  PairKind kind;
  unsigned joined;   ///< of a corner: a bit for each of the particles that an edge joins it to
  double thickness;  ///< that they are kept apart by [m]
  double distance;   ///< when they were found [m]
};

/// Where particles are [m], in the engine's order.
using Places = std::vector<Vec3>;

inline PairPlaces places_of(const ClosePair& pair, const Places& places) {
  return {places[pair.particles[0]], places[pair.particles[1]], places[pair.particles[2]],
          places[pair.particles[3]]};
}

/// The corners, edges and triangles of a surface, in the engine's numbering.
struct Surface {
  explicit Surface(std::vector<Triangle> triangles);

  std::vector<Triangle> triangles;
  std::vector<Edge> edges;
  std::vector<Index> corners;  ///< sorted

  bool is_edge(Index a, Index b) const;
};

/// Finds the pairs of a surface that are near each other.
class ClosePairs {
 public:
  /// `rest` are the places at the start of the scene: what is nearer than `thickness` there has its distance
  /// there for its own thickness.
  ClosePairs(const Surface& surface, Places rest, double thickness);

  /// All pairs without a common particle that get within `reach` [m] of each other on straight ways from
  /// `start` to `end`, and some more; sorted, and the same on any number of threads.
  const std::vector<ClosePair>& find(const Places& start, const Places& end, double reach,
                                     Executor& executor);

  std::size_t bytes() const;

 private:
  /// What one run of corners or edges finds.
  using Found = std::vector<ClosePair>;

  template <class Find>
  void find_in_runs(std::size_t count, const Find& find, Executor& executor);
  void find_at_corner(Index corner, Found& found) const;
  void find_at_edge(std::size_t edge, Found& found) const;
  void add_if_near(const std::array<Index, 4>& particles, PairKind kind, Found& found) const;
  template <std::size_t n>
  AxisBox box_around(const std::array<Index, n>& particles) const;

  const Surface& surface_;
  Places rest_;
  double thickness_, reach_ = 0.0;
  const Places *start_ = nullptr, *end_ = nullptr;
  std::vector<AxisBox> triangle_boxes_, edge_boxes_;
  HashGrid triangles_, edges_;
  std::vector<Found> runs_;
  std::vector<ClosePair> pairs_;
};

}  // namespace hooke
