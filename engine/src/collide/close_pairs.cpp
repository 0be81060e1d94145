#include "collide/close_pairs.h"

#include <algorithm>

#include "collide/swept_test.h"

namespace hooke {
namespace {

/// Groups of corners or edges that one thread takes at a time.
constexpr std::size_t groups_at_once = 8;

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

void ClosePairs::make_boxes(Executor& executor) {
  const auto for_each = [&](std::size_t count, const auto& make) {
    executor.parallel_for(count, boxes_at_once, [&](std::size_t begin, std::size_t last) {
      for (std::size_t i = begin; i < last; ++i) make(i);
    });
  };
  corner_boxes_.resize(surface_.corners.size());
  triangle_boxes_.resize(surface_.triangles.size());
  edge_boxes_.resize(surface_.edges.size());
  for_each(corner_boxes_.size(),
           [&](std::size_t c) { corner_boxes_[c] = box_around(std::array{surface_.corners[c]}); });
  for_each(triangle_boxes_.size(),
           [&](std::size_t t) { triangle_boxes_[t] = box_around(surface_.triangles[t]); });
  for_each(edge_boxes_.size(), [&](std::size_t e) {
    edge_boxes_[e] = box_around(std::array{surface_.edges[e].first, surface_.edges[e].second});
  });
  const BoxFrame frame(corner_boxes_);
  corners_.build(corner_boxes_, frame, executor);
  triangles_.build(triangle_boxes_, frame, executor);
  edges_.build(edge_boxes_, frame, executor);
}

const std::vector<ClosePair>& ClosePairs::find(const Places& start, const Places& end, double reach,
                                               Executor& executor) {
  start_ = &start, end_ = &end, reach_ = reach;
  make_boxes(executor);
  pairs_.clear();
  const auto add_triangle = [&](Index corner, Index triangle, Found& found) {
    const auto [a, b, c] = surface_.triangles[triangle];
    add_if_near({surface_.corners[corner], a, b, c}, PairKind::corner_triangle, found);
  };
  find_in_groups(corners_, surface_.corners.size(), triangles_, add_triangle, executor);
  const auto add_edge = [&](Index edge, Index other, Found& found) {
    if (other <= edge) return;
    const auto [a, b] = surface_.edges[edge];
    const auto [c, d] = surface_.edges[other];
    add_if_near({a, b, c, d}, PairKind::edge_edge, found);
  };
  find_in_groups(edges_, surface_.edges.size(), edges_, add_edge, executor);
  return pairs_;
}

template <class Add>
void ClosePairs::find_in_groups(const BoxTree& first, std::size_t count, const BoxTree& second,
                                const Add& add, Executor& executor) {
  const std::size_t runs = first.groups();
  if (runs_.size() < runs) runs_.resize(runs);
  executor.parallel_for(runs, groups_at_once, [&](std::size_t begin, std::size_t end) {
    for (std::size_t run = begin; run < end; ++run) find_in_group(first, second, run, add, runs_[run]);
  });
  collect(count, runs, executor);
}

template <class Add>
void ClosePairs::find_in_group(const BoxTree& first, const BoxTree& second, std::size_t group, const Add& add,
                               Run& run) {
  const std::span<const Index> elements = first.group(group);
  std::copy(elements.begin(), elements.end(), run.elements.begin());
  run.counts.fill(0);
  run.found.clear();
  second.for_each_meeting(first, group, run.near, [&](std::size_t n, Index other) {
    const std::size_t before = run.found.size();
    add(run.elements[n], other, run.found);
    run.counts[n] += run.found.size() - before;
  });
  auto at = run.found.begin();
  for (const std::size_t count : run.counts) {
    const auto last = at + std::ptrdiff_t(count);
    std::sort(at, last, [](const ClosePair& a, const ClosePair& b) { return a.particles < b.particles; });
    at = last;
  }
}

/// Puts what groups have found in the order of their elements, after the pairs that are there.
void ClosePairs::collect(std::size_t count, std::size_t runs, Executor& executor) {
  begin_.assign(count + 1, 0);
  for (std::size_t r = 0; r < runs; ++r) {
    for (std::size_t n = 0; n < BoxGroup::size; ++n) {
      if (runs_[r].counts[n] > 0) begin_[runs_[r].elements[n] + 1] = runs_[r].counts[n];
    }
  }
  begin_[0] = pairs_.size();
  for (std::size_t e = 0; e < count; ++e) begin_[e + 1] += begin_[e];
  pairs_.resize(begin_[count]);
  executor.parallel_for(runs, groups_at_once, [&](std::size_t first, std::size_t end) {
    for (std::size_t r = first; r < end; ++r) {
      auto from = runs_[r].found.begin();
      for (std::size_t n = 0; n < BoxGroup::size && from != runs_[r].found.end(); ++n) {
        const auto last = from + std::ptrdiff_t(runs_[r].counts[n]);
        if (from != last)
          std::copy(from, last, pairs_.begin() + std::ptrdiff_t(begin_[runs_[r].elements[n]]));
        from = last;
      }
    }
  });
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
  std::size_t found = pairs_.capacity(), near = 0;
  for (const Run& run : runs_) found += run.found.capacity(), near += run.near.capacity();
  return found * sizeof(ClosePair) + runs_.capacity() * sizeof(Run) +
         (near + begin_.capacity()) * sizeof(std::size_t) + rest_.capacity() * sizeof(Vec3) +
         corners_.bytes() + triangles_.bytes() + edges_.bytes() +
         (corner_boxes_.capacity() + triangle_boxes_.capacity() + edge_boxes_.capacity()) * sizeof(AxisBox);
}

}  // namespace hooke
