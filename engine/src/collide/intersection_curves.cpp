#include "collide/intersection_curves.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace hooke {
namespace {

Vec3 place_of(const Crossing& crossing, const Surface& surface, const Places& places) {
  const auto [a, b] = surface.edges[crossing.edge];
  return places[a] + crossing.along * (places[b] - places[a]);
}

/// The number of an edge of the surface.
Index number_of(Index a, Index b, const Surface& surface) {
  const Edge edge{std::min(a, b), std::max(a, b)};
  return Index(std::lower_bound(surface.edges.begin(), surface.edges.end(), edge) - surface.edges.begin());
}

void sum_up(std::vector<std::size_t>& begin) {
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
}

}  // namespace

IntersectionCurves::IntersectionCurves(const Surface& surface) : surface_(surface) {
  triangles_begin_.assign(surface.edges.size() + 1, 0);
  std::vector<std::pair<Index, Index>> sides;
  for (Index t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    for (const auto& [p, q] : {Edge(a, b), Edge(b, c), Edge(c, a)})
      sides.emplace_back(number_of(p, q, surface), t);
  }
  std::sort(sides.begin(), sides.end());
  for (const auto& [edge, triangle] : sides) ++triangles_begin_[edge + 1], triangles_.push_back(triangle);
  sum_up(triangles_begin_);
  const std::size_t particles = surface.corners.empty() ? 0 : surface.corners.back() + std::size_t{1};
  neighbours_begin_.assign(particles + 1, 0);
  for (const auto& [a, b] : surface.edges) ++neighbours_begin_[a + 1], ++neighbours_begin_[b + 1];
  sum_up(neighbours_begin_);
  neighbours_.resize(2 * surface.edges.size());
  std::vector<std::size_t> next = neighbours_begin_;
  for (Index e = 0; e < surface.edges.size(); ++e) {
    const auto [a, b] = surface.edges[e];
    neighbours_[next[a]++] = {b, e}, neighbours_[next[b]++] = {a, e};
  }
  is_cut_.assign(surface.edges.size(), 0);
  part_.assign(particles, none);
}

std::span<const Index> IntersectionCurves::triangles_at(Index edge) const {
  return {triangles_.data() + triangles_begin_[edge], triangles_begin_[edge + 1] - triangles_begin_[edge]};
}

std::span<const IntersectionCurves::Place> IntersectionCurves::trace(const std::vector<Crossing>& crossings,
                                                                     const Places& places) {
  places_.assign(crossings.size(), {});
  entangled_.clear();
  join_crossings(crossings, places);
  number_curves(crossings);
  fill_regions(crossings);
  add_at_curve(crossings);
  sort_entangled();
  return places_;
}

/// Two triangles cross in a line between two crossings, or between one and a corner that they share.
void IntersectionCurves::join_crossings(const std::vector<Crossing>& crossings, const Places& places) {
  links_.clear();
  for (Index c = 0; c < crossings.size(); ++c) {
    for (const Index t : triangles_at(crossings[c].edge))
      links_.push_back({std::minmax(t, crossings[c].triangle), c});
  }
  std::sort(links_.begin(), links_.end(), [](const Link& a, const Link& b) {
    return std::tie(a.triangles, a.crossing) < std::tie(b.triangles, b.crossing);
  });
  joined_.clear();
  for (std::size_t i = 0; i < links_.size();) {
    if (i + 1 < links_.size() && links_[i].triangles == links_[i + 1].triangles) {
      join(links_[i].crossing, links_[i + 1].crossing, crossings, places);
      i += 2;
    } else {
      end_at_common_corner(links_[i], crossings, places);
      ++i;
    }
  }
  std::sort(joined_.begin(), joined_.end());
}

void IntersectionCurves::join(Index a, Index b, const std::vector<Crossing>& crossings,
                              const Places& places) {
  joined_.emplace_back(a, b), joined_.emplace_back(b, a);
  const Vec3 way = place_of(crossings[b], surface_, places) - place_of(crossings[a], surface_, places);
  places_[a].onwards += way.stableNormalized();
  places_[b].onwards -= way.stableNormalized();
}

void IntersectionCurves::end_at_common_corner(const Link& link, const std::vector<Crossing>& crossings,
                                              const Places& places) {
  const Triangle& other = surface_.triangles[link.triangles.second];
  for (const Index corner : surface_.triangles[link.triangles.first]) {
    if (std::find(other.begin(), other.end(), corner) == other.end()) continue;
    const Vec3 way = places[corner] - place_of(crossings[link.crossing], surface_, places);
    places_[link.crossing].onwards += way.stableNormalized();
    places_[link.crossing].corner = corner;
    return;
  }
}

/// Of two crossings that follow one another, the edges are on one side if they cross the same triangle.
void IntersectionCurves::number_curves(const std::vector<Crossing>& crossings) {
  Index curves = 0;
  std::vector<Index> reached;
  for (Index first = 0; first < crossings.size(); ++first) {
    if (places_[first].curve != none) continue;
    places_[first].curve = curves;
    reached.assign(1, first);
    while (!reached.empty()) {
      const Index c = reached.back();
      reached.pop_back();
      auto next = std::lower_bound(joined_.begin(), joined_.end(), std::pair(c, Index{0}));
      for (; next != joined_.end() && next->first == c; ++next) {
        Place& place = places_[next->second];
        if (place.curve != none) continue;
        const bool is_same = crossings[next->second].triangle == crossings[c].triangle;
        place.curve = curves;
        place.side = is_same ? places_[c].side : 1 - places_[c].side;
        reached.push_back(next->second);
      }
    }
    ++curves;
  }
}

void IntersectionCurves::fill_regions(const std::vector<Crossing>& crossings) {
  std::vector<Index> sorted(crossings.size());
  std::iota(sorted.begin(), sorted.end(), Index{0});
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](Index a, Index b) { return places_[a].curve < places_[b].curve; });
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
    while (end < sorted.size() && places_[sorted[end]].curve == places_[sorted[begin]].curve) ++end;
    fill_regions_of({sorted.data() + begin, end - begin}, crossings);
  }
}

void IntersectionCurves::fill_regions_of(std::span<const Index> curve,
                                         const std::vector<Crossing>& crossings) {
  parts_begin_.assign(1, 0);
  filled_.clear();
  for (const Index c : curve) {
    is_cut_[crossings[c].edge] = 1;
    if (places_[c].corner != none) part_[places_[c].corner] = on_curve;
  }
  const auto size_of = [&](Index part) { return parts_begin_[part + 1] - parts_begin_[part]; };
  std::vector<std::pair<Index, unsigned>> cut_off;
  for (const Index c : curve) {
    const auto [a, b] = surface_.edges[crossings[c].edge];
    const Index at_a = part_of(a), at_b = part_of(b);
    if (at_a == at_b || at_a == on_curve || at_b == on_curve) continue;
    const bool is_a = std::pair(size_of(at_a), at_a) < std::pair(size_of(at_b), at_b);
    places_[c].inside = is_a ? a : b;
    cut_off.emplace_back(is_a ? at_a : at_b, places_[c].side);
  }
  std::sort(cut_off.begin(), cut_off.end());
  cut_off.erase(std::unique(cut_off.begin(), cut_off.end()), cut_off.end());
  for (const auto& [part, side] : cut_off) {
    for (std::size_t i = parts_begin_[part]; i < parts_begin_[part + 1]; ++i)
      add(filled_[i], places_[curve[0]].curve, side);
  }
  for (const Index c : curve) {
    is_cut_[crossings[c].edge] = 0;
    if (places_[c].corner != none) part_[places_[c].corner] = none;
  }
  for (const Index particle : filled_) part_[particle] = none;
}

/// The part of the surface that a particle is in, as the curve cuts it; filled when it is asked for.
Index IntersectionCurves::part_of(Index particle) {
  if (part_[particle] != none) return part_[particle];
  const Index part = Index(parts_begin_.size() - 1);
  part_[particle] = part;
  filled_.push_back(particle);
  for (std::size_t i = parts_begin_.back(); i < filled_.size(); ++i) {
    for (std::size_t n = neighbours_begin_[filled_[i]]; n < neighbours_begin_[filled_[i] + 1]; ++n) {
      const Neighbour& neighbour = neighbours_[n];
      if (is_cut_[neighbour.edge] != 0 || part_[neighbour.particle] != none) continue;
      part_[neighbour.particle] = part;
      filled_.push_back(neighbour.particle);
    }
  }
  parts_begin_.push_back(filled_.size());
  return part;
}

void IntersectionCurves::add_at_curve(const std::vector<Crossing>& crossings) {
  for (std::size_t c = 0; c < crossings.size(); ++c) {
    const Place& place = places_[c];
    for (const Index t : triangles_at(crossings[c].edge)) {
      for (const Index corner : surface_.triangles[t]) add(corner, place.curve, place.side);
    }
    for (const Index corner : surface_.triangles[crossings[c].triangle])
      add(corner, place.curve, 1 - place.side);
  }
}

void IntersectionCurves::sort_entangled() {
  std::sort(entangled_.begin(), entangled_.end(), [](const Entangled& a, const Entangled& b) {
    return std::tie(a.particle, a.curve) < std::tie(b.particle, b.curve);
  });
  entangled_begin_.assign(neighbours_begin_.size(), 0);
  std::size_t count = 0;
  for (const Entangled& entry : entangled_) {
    Entangled* last = count > 0 ? &entangled_[count - 1] : nullptr;
    if (last != nullptr && last->particle == entry.particle && last->curve == entry.curve) {
      last->sides |= entry.sides;
    } else {
      entangled_[count++] = entry;
      ++entangled_begin_[entry.particle + 1];
    }
  }
  entangled_.resize(count);
  sum_up(entangled_begin_);
}

std::span<const IntersectionCurves::Entangled> IntersectionCurves::entangled(Index particle) const {
  return {entangled_.data() + entangled_begin_[particle],
          entangled_begin_[particle + 1] - entangled_begin_[particle]};
}

bool IntersectionCurves::are_entangled(const ClosePair& pair) const {
  const std::size_t in_first = pair.kind == PairKind::corner_triangle ? 1 : 2;
  for (std::size_t i = 0; i < in_first; ++i) {
    for (const Entangled& a : entangled(pair.particles[i])) {
      for (std::size_t j = in_first; j < 4; ++j) {
        for (const Entangled& b : entangled(pair.particles[j])) {
          const bool on_both = (a.sides | b.sides) == 3u;
          if (a.curve == b.curve && on_both) return true;
        }
      }
    }
  }
  return false;
}

std::size_t IntersectionCurves::bytes() const {
  return triangles_.capacity() * sizeof(Index) + neighbours_.capacity() * sizeof(Neighbour) +
         (triangles_begin_.capacity() + neighbours_begin_.capacity() + entangled_begin_.capacity()) *
             sizeof(std::size_t) +
         places_.capacity() * sizeof(Place) + links_.capacity() * sizeof(Link) +
         joined_.capacity() * sizeof(joined_[0]) + entangled_.capacity() * sizeof(Entangled) +
         (part_.capacity() + filled_.capacity()) * sizeof(Index) + is_cut_.capacity();
}

}  // namespace hooke
