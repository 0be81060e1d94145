#pragma once

#include <array>
#include <vector>

#include <hooke/executor.h>
#include <hooke/scene.h>

#include "collide/box_tree.h"
#include "collide/closest_points.h"
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
  Surface() = default;
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

  /// Boxes around all edges and triangles on these ways, which meet where they get within the reach.
  const BoxTree& edge_boxes() const { return edges_; }
  const BoxTree& triangle_boxes() const { return triangles_; }

  std::size_t bytes() const;

 private:
  using Found = std::vector<ClosePair>;

  /// What a group of corners or edges finds: so many pairs of each, one after the other.
  struct Run {
    std::vector<std::size_t> near;
    Found found;
    std::array<Index, BoxGroup::size> elements;
    std::array<std::size_t, BoxGroup::size> counts;
  };

  void make_boxes(Executor& executor);
  template <class Add>
  void find_in_groups(const BoxTree& first, std::size_t count, const BoxTree& second, const Add& add,
                      Executor& executor);
  template <class Add>
  static void find_in_group(const BoxTree& first, const BoxTree& second, std::size_t group, const Add& add,
                            Run& run);
  void collect(std::size_t count, std::size_t runs, Executor& executor);
  void add_if_near(const std::array<Index, 4>& particles, PairKind kind, Found& found) const;
  template <std::size_t n>
  AxisBox box_around(const std::array<Index, n>& particles) const;

  const Surface& surface_;
  Places rest_;
  double thickness_, reach_ = 0.0;
  const Places *start_ = nullptr, *end_ = nullptr;
  std::vector<AxisBox> corner_boxes_, triangle_boxes_, edge_boxes_;
  BoxTree corners_, triangles_, edges_;
  std::vector<Run> runs_;
  std::vector<std::size_t> begin_;  ///< of each corner's or edge's pairs
  std::vector<ClosePair> pairs_;
};

}  // namespace hooke
