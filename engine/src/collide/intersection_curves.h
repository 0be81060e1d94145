#pragma once

#include <span>
#include <utility>
#include <vector>

#include "collide/crossings.h"

namespace hooke {

/// The curves in which a surface crosses itself, and what they cut off (Baraff, Witkin, Kass 2003). A curve
/// has two sides, one on each of the two pieces of the surface that cross in it: from a crossing it goes on,
/// through a triangle at the edge and the triangle that the edge crosses, to the next crossing of these two.
class IntersectionCurves {
 public:
  explicit IntersectionCurves(const Surface& surface);

  /// What a curve says of a crossing.
  struct Place {
    Index curve = none;
    unsigned side = 0;    ///< of the curve, 0 or 1, that the edge is on; the triangle is on the other
    Index inside = none;  ///< the end of the edge in a region that the curve cuts off
    Index corner = none;  ///< in which the curve ends: the two triangles share it, and its sides meet there
    Vec3 onwards = Vec3::Zero();  ///< the unit vectors to the next places of the curve, summed
  };

  /// Traces the curves of crossings as found in `places`, and fills the regions that they cut off: what a
  /// curve, with both its sides, parts from the rest of the surface, and is the smaller of the two parts.
  /// A place for each crossing. Valid until the next call.
  std::span<const Place> trace(const std::vector<Crossing>& crossings, const Places& places);

  /// Whether the pieces of a pair are on the two sides of one curve: at it, or in the regions cut off.
  bool are_entangled(const ClosePair& pair) const;

  std::size_t bytes() const;

 private:
  static constexpr Index none = ~Index{0}, on_curve = none - 1;

  /// A particle on sides of a curve, as bits.
  struct Entangled {
    Index particle, curve;
    unsigned sides;
  };
  struct Neighbour {
    Index particle, edge;
  };
  /// The triangles that a curve goes through from a crossing on, the lower number first.
  struct Link {
    std::pair<Index, Index> triangles;
    Index crossing;
  };

  std::span<const Index> triangles_at(Index edge) const;
  void join_crossings(const std::vector<Crossing>& crossings, const Places& places);
  void join(Index a, Index b, const std::vector<Crossing>& crossings, const Places& places);
  void end_at_common_corner(const Link& link, const std::vector<Crossing>& crossings, const Places& places);
  void number_curves(const std::vector<Crossing>& crossings);
  void fill_regions(const std::vector<Crossing>& crossings);
  void fill_regions_of(std::span<const Index> curve, const std::vector<Crossing>& crossings);
  Index part_of(Index particle);
  void add_at_curve(const std::vector<Crossing>& crossings);
  void add(Index particle, Index curve, unsigned side) {
    entangled_.push_back({particle, curve, 1u << side});
  }
  void sort_entangled();
  std::span<const Entangled> entangled(Index particle) const;

  const Surface& surface_;
  std::vector<Index> triangles_;  ///< of each edge
  std::vector<std::size_t> triangles_begin_;
  std::vector<Neighbour> neighbours_;  ///< of each particle
  std::vector<std::size_t> neighbours_begin_;
  std::vector<Place> places_;
  std::vector<Link> links_;
  std::vector<std::pair<Index, Index>> joined_;  ///< crossings that follow one another, both ways round
  std::vector<Entangled> entangled_;
  std::vector<std::size_t> entangled_begin_;
  // Of the curve whose regions are being filled:
  std::vector<unsigned char> is_cut_;     ///< of each edge
  std::vector<Index> part_;               ///< of each particle; on_curve where the curve ends in it
  std::vector<std::size_t> parts_begin_;  ///< of each part, in `filled_`; one more than there are parts
  std::vector<Index> filled_;
};

}  // namespace hooke
