#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "tearing/torn_scene.h"

namespace hooke {

/// A scene while it tears: what is at each particle, as particles are split one after the other. Springs keep
/// their numbers meanwhile; new ones come behind them, and those that are gone are marked.
class Fabric {
 public:
  Fabric(const Scene& scene, std::vector<Vec3> positions);

  /// See tear().
  void tear(Index spring);

  TornScene finish() &&;

 private:
  /// Bits.
  enum Side : unsigned { near_side = 1, far_side = 2 };

  /// Through a particle, across a spring: the spring's other end is on the far side.
  struct Plane {
    Vec3 origin, normal;

    unsigned sides_of(const Vec3& place) const;  ///< both of what is in it
  };

  /// How what is at a particle is to be shared out.
  struct Cut {
    Index particle;
    Plane plane;
    std::vector<Index> near_triangles, far_triangles;
    std::vector<Index> far_springs;     ///< that go over
    std::vector<Index> shared_springs;  ///< edges of triangles on both sides
    std::vector<Index> led_springs;  ///< that are no edges, and go with the triangles that lead to their end
    std::size_t near_parts = 0, far_parts = 0;  ///< triangles and springs beside them

    bool splits() const { return near_parts > 0 && far_parts > 0; }
  };

  /// A line of LaplacianBending.
  struct Line {
    std::size_t effect, number;
  };

  Plane plane_across(Index particle, Index spring) const;
  Cut cut_at(Index particle, Index spring) const;
  void share_triangles(Index other_end, Cut& cut) const;
  void share_springs(Index torn, Cut& cut) const;
  bool is_better(const Cut& cut, const Cut& other) const;
  bool at_border(Index particle) const;
  double far_share_of_mass(const Cut& cut) const;
  double area_at_rest(const std::vector<Index>& triangles) const;

  void split(const Cut& cut);
  Index add_particle(const Cut& cut);
  void share_out_spring(Index spring, const Cut& cut, Index added);
  void put_end(Index spring, Index from, Index to);
  void remove(Index spring);
  void share_out_lines(const Cut& cut, Index added);
  unsigned side_of_line(const LaplacianBending& bending, std::size_t line, const Cut& cut) const;
  void drop_lines();

  /// The springs that would bridge a cut, where nothing else leads from the one end to the other.
  std::vector<Index> across(const Cut& cut) const;
  std::vector<Index> straight_through(const Cut& cut) const;

  static bool contains(const std::vector<Index>& list, Index one) {
    return std::ranges::find(list, one) != list.end();
  }
  std::vector<Index> corners_of(const std::vector<Index>& triangles, Index without) const;
  bool has_corner(Index triangle, Index particle) const;
  unsigned edge_sides(Index end, const Cut& cut) const;
  unsigned led_sides(Index end, const Cut& cut) const;
  unsigned sides_of(Index end, const Cut& cut) const;
  bool share_triangle(Index a, Index b) const;
  bool two_edges_lead(Index a, Index b) const;
  bool is_edge(Index spring) const { return share_triangle(ends(spring)[0], ends(spring)[1]); }
  std::array<Index, 2> ends(Index spring) const {
    return {scene_.springs.first[spring], scene_.springs.second[spring]};
  }

  void find_lines();
  std::vector<RelaxingSpring> relaxing_springs(const Scene& torn,
                                               const std::vector<Index>& number_after) const;

  Scene scene_;
  std::vector<Vec3> positions_;
  std::size_t springs_before_;
  std::vector<std::vector<Index>> springs_at_, triangles_at_;
  std::vector<std::vector<Line>> lines_at_;  ///< empty of a scene without any
  std::vector<bool> held_, torn_at_;         ///< of particles
  std::vector<Line> gone_lines_;
  std::vector<Index> unsplit_;  ///< edges that tore nothing
  std::vector<bool> gone_;      ///< of springs
  std::vector<Index> spring_from_, split_from_;
};

}  // namespace hooke
