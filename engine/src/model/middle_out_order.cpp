#include "model/middle_out_order.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace hooke {
namespace {

using Distances = std::vector<std::uint32_t>;

constexpr std::uint32_t unreached = ~std::uint32_t{0};

/// Orders one connected part at a time. Distances are numbers of springs on the shortest way.
class MiddleOut {
 public:
  explicit MiddleOut(const NeighbourGraph& graph) : graph_(graph), numbered_(graph.size(), false) {
    for (Distances& distances : from_) distances.resize(graph.size());
    order_.reserve(graph.size());
    for (const NeighbourGraph::Part& part : graph.parts()) add(part);
  }

  std::vector<Index> take() { return std::move(order_); }

 private:
  /// The particles as near to `second` as to `first`, or nearer, are one side of a cut, all others the other
  /// one. Either is connected: on the shortest way to its end no particle is of the other side.
  struct Cut {
    const Distances *first, *second;
    bool before(Index i) const { return (*first)[i] < (*second)[i]; }
  };

  void add(const NeighbourGraph::Part& part) {
    if (part.end - part.begin == 1) {
      order_.push_back(graph_.user(part.begin));
      return;
    }
    measure_from_ends(part);
    Cut cut{};
    std::vector<Index> front = narrowest_front(part, cut);
    sort_along(front, part, *cut.first);
    number_both_ways(front, cut);
  }

  /// Distances from the two ends of the part and from the particle that is furthest from both. In a square
  /// sheet these are three of its corners, in a long one two, and a particle half-way along a side.
  void measure_from_ends(const NeighbourGraph::Part& part) {
    const Index first = part.end - 1;  // the last that a breadth-first walk came to
    const Index second = measure(first, part, from_[0]);
    measure(second, part, from_[1]);
    Index third = part.begin;
    const auto to_nearer_end = [&](Index i) { return std::min(from_[0][i], from_[1][i]); };
    for (Index i = part.begin; i < part.end; ++i) {
      if (to_nearer_end(i) > to_nearer_end(third)) third = i;
    }
    measure(third, part, from_[2]);
  }

  /// Writes the distances from `start` to all of its part, and gives the last of the furthest ones.
  Index measure(Index start, const NeighbourGraph::Part& part, Distances& distances) {
    std::fill(distances.begin() + part.begin, distances.begin() + part.end, unreached);
    walk_.assign(1, start);
    distances[start] = 0;
    for (std::size_t next = 0; next < walk_.size(); ++next) {
      for (Index neighbour : graph_.neighbours(walk_[next])) {
        if (distances[neighbour] != unreached) continue;
        distances[neighbour] = distances[walk_[next]] + 1;
        walk_.push_back(neighbour);
      }
    }
    return walk_.back();
  }

  /// Of the cuts half-way between two of the three particles, the one that fewest particles lie at.
  std::vector<Index> narrowest_front(const NeighbourGraph::Part& part, Cut& narrowest) const {
    std::vector<Index> result;
    for (const auto& [a, b] : {std::array{0, 1}, std::array{0, 2}, std::array{1, 2}}) {
      const Cut cut{&from_[a], &from_[b]};
      std::vector<Index> front = front_of(cut, part);
      if (front.empty() || (!result.empty() && front.size() >= result.size())) continue;
      result = std::move(front);
      narrowest = cut;
    }
    return result;
  }

  /// The particles behind the cut with a neighbour before it. There are some if the cut's ends are two
  /// particles.
  std::vector<Index> front_of(const Cut& cut, const NeighbourGraph::Part& part) const {
    std::vector<Index> front;
    for (Index i = part.begin; i < part.end; ++i) {
      if (cut.before(i)) continue;
      const auto neighbours = graph_.neighbours(i);
      if (std::any_of(neighbours.begin(), neighbours.end(), [&](Index n) { return cut.before(n); }))
        front.push_back(i);
    }
    return front;
  }

  /// Sorts a front from one of its ends on: those are what is furthest from the ends of the cut.
  void sort_along(std::vector<Index>& front, const NeighbourGraph::Part& part,
                  const Distances& from_cut_end) {
    const auto nearer = [&](Index i, Index j) { return from_cut_end[i] < from_cut_end[j]; };
    measure(*std::max_element(front.begin(), front.end(), nearer), part, along_front());
    std::stable_sort(front.begin(), front.end(),
                     [this](Index i, Index j) { return along_front()[i] < along_front()[j]; });
  }

  /// Numbers what is behind the cut upwards from the front, and what is before it downwards. The levels
  /// before it begin from the far end of the front: so the last of the one and the first of the other are
  /// neighbours, and the ends of any spring across the cut are about one level apart.
  void number_both_ways(const std::vector<Index>& front, const Cut& cut) {
    std::vector<Index> before, behind = front;
    for (Index i : front) numbered_[i] = true;
    for (auto i = front.rbegin(); i != front.rend(); ++i)
      visit_neighbours(*i, before, [&](Index n) { return cut.before(n); });
    for (std::vector<Index>* side : {&before, &behind}) {
      const bool is_before = side == &before;
      for (std::size_t next = 0; next < side->size(); ++next)
        visit_neighbours((*side)[next], *side, [&](Index n) { return cut.before(n) == is_before; });
    }
    for (auto i = before.rbegin(); i != before.rend(); ++i) order_.push_back(graph_.user(*i));
    for (Index i : behind) order_.push_back(graph_.user(i));
  }

  template <class IsOnSide>
  void visit_neighbours(Index i, std::vector<Index>& side, const IsOnSide& is_on_side) {
    for (Index neighbour : graph_.neighbours(i)) {
      if (numbered_[neighbour] || !is_on_side(neighbour)) continue;
      numbered_[neighbour] = true;
      side.push_back(neighbour);
    }
  }

  Distances& along_front() { return from_[3]; }

  const NeighbourGraph& graph_;
  std::vector<bool> numbered_;
  std::array<Distances, 4> from_;  ///< three particles of the part, and an end of the front
  std::vector<Index> walk_, order_;
};

}  // namespace

std::vector<Index> middle_out_order(const NeighbourGraph& graph) {
  return MiddleOut(graph).take();
}

}  // namespace hooke
