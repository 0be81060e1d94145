#include "collide/close_pairs.h"

#include <algorithm>

#include "collide/swept_test.h"

namespace hooke {
namespace {

/// Corners or edges that one thread takes at a time.
constexpr std::size_t in_run = 512;

/// Boxes that one thread makes at a time.
constexpr std::size_t boxes_at_once = 4096;

bool share_a_particle(const std::array<Index, 4>& p, PairKind kind) {
  if (kind == PairKind::corner_triangle) return p[0] == p[1] || p[0] == p[2] || p[0] == p[3];
  return p[0] == p[2] || p[0] == p[3] || p[1] == p[2] || p[1] == p[3];
}

PairPlaces places_of(const std::array<Index, 4>& particles, const Places& places) {
  return {places[particles[0]], places[particles[1]], places[particles[2]], places[particles[3]]};
}

}  // namespace

Surface::Surface(std::vector<Triangle> of) : triangles(std::move(of)) {
  edges = edges_of(sides_of(triangles));
  for (const Triangle& triangle : triangles) corners.insert(corners.end(), triangle.begin(), triangle.end());
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
}

bool Surface::is_edge(Index a, Index b) const {
  return std::binary_search(edges.begin(), edges.end(), Edge(std::min(a, b), std::max(a, b)));
}

ClosePairs::ClosePairs(const Surface& surface, Places rest, double thickness)
    : surface_(surface), rest_(std::move(rest)), thickness_(thickness) {}

template <std::size_t n>
AxisBox ClosePairs::box_around(const std::array<Index, n>& particles) const {
  AxisBox box;
  for (const Index particle : particles) {
    box.widen((*start_)[particle]);
    box.widen((*end_)[particle]);
  }
  box.grow(0.5 * reach_);
  return box;
}

const std::vector<ClosePair>& ClosePairs::find(const Places& start, const Places& end, double reach,
                                               Executor& executor) {
  start_ = &start, end_ = &end, reach_ = reach;
  triangle_boxes_.resize(surface_.triangles.size());
  edge_boxes_.resize(surface_.edges.size());
  executor.parallel_for(triangle_boxes_.size(), boxes_at_once, [&](std::size_t begin, std::size_t last) {
    for (std::size_t t = begin; t < last; ++t) triangle_boxes_[t] = box_around(surface_.triangles[t]);
  });
  executor.parallel_for(edge_boxes_.size(), boxes_at_once, [&](std::size_t begin, std::size_t last) {
    for (std::size_t e = begin; e < last; ++e) {
      const auto& [a, b] = surface_.edges[e];
      edge_boxes_[e] = box_around(std::array{a, b});
    }
  });
  executor.parallel_for(2, 1, [&](std::size_t begin, std::size_t last) {
    for (std::size_t which = begin; which < last; ++which)
      which == 0 ? triangles_.build(triangle_boxes_) : edges_.build(edge_boxes_);
  });
  pairs_.clear();
  const auto at_corner = [&](std::size_t c, Found& found) { find_at_corner(surface_.corners[c], found); };
  find_in_runs(surface_.corners.size(), at_corner, executor);
  const auto at_edge = [&](std::size_t e, Found& found) { find_at_edge(e, found); };
  find_in_runs(surface_.edges.size(), at_edge, executor);
  return pairs_;
}

template <class Find>
void ClosePairs::find_in_runs(std::size_t count, const Find& find, Executor& executor) {
  const std::size_t runs = (count + in_run - 1) / in_run;
  if (runs_.size() < runs) runs_.resize(runs);
  executor.parallel_for(runs, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t run = begin; run < end; ++run) {
      runs_[run].clear();
      for (std::size_t i = run * in_run; i < std::min(count, (run + 1) * in_run); ++i) find(i, runs_[run]);
    }
  });
  for (std::size_t run = 0; run < runs; ++run)
    pairs_.insert(pairs_.end(), runs_[run].begin(), runs_[run].end());
}

void ClosePairs::find_at_corner(Index corner, Found& found) const {
  const std::size_t first = found.size();
  triangles_.for_each_meeting(box_around(std::array{corner}), 0, [&](Index t) {
    const auto [a, b, c] = surface_.triangles[t];
    add_if_near({corner, a, b, c}, PairKind::corner_triangle, found);
  });
  std::sort(found.begin() + std::ptrdiff_t(first), found.end(),
            [](const ClosePair& a, const ClosePair& b) { return a.particles < b.particles; });
}

void ClosePairs::find_at_edge(std::size_t edge, Found& found) const {
  const std::size_t first = found.size();
  const auto [a, b] = surface_.edges[edge];
  edges_.for_each_meeting(edge_boxes_[edge], Index(edge) + 1, [&, a = a, b = b](Index other) {
    const auto [c, d] = surface_.edges[other];
    add_if_near({a, b, c, d}, PairKind::edge_edge, found);
  });
  std::sort(found.begin() + std::ptrdiff_t(first), found.end(),
            [](const ClosePair& one, const ClosePair& two) { return one.particles < two.particles; });
}

void ClosePairs::add_if_near(const std::array<Index, 4>& particles, PairKind kind, Found& found) const {
  if (share_a_particle(particles, kind)) return;
  const PairPlaces end = places_of(particles, *end_);
  const double distance = closest_points(kind, end).distance();
  const double approach = start_ == end_ ? 0.0 : approach_bound(kind, places_of(particles, *start_), end);
  if (!(distance - approach <= reach_)) return;
  const double at_rest = closest_points(kind, places_of(particles, rest_)).distance();
  unsigned joined = 0;
  for (unsigned k = 1; k < 4 && kind == PairKind::corner_triangle; ++k)
    joined |= surface_.is_edge(particles[0], particles[k]) ? 1u << k : 0u;
  found.push_back({particles, kind, joined, std::min(thickness_, at_rest), distance});
}

std::size_t ClosePairs::bytes() const {
  std::size_t found = pairs_.capacity();
  for (const Found& run : runs_) found += run.capacity();
  return found * sizeof(ClosePair) + rest_.capacity() * sizeof(Vec3) + triangles_.bytes() + edges_.bytes() +
         (triangle_boxes_.capacity() + edge_boxes_.capacity()) * sizeof(AxisBox);
}

}  // namespace hooke
