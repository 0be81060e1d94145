#include "model/neighbour_graph.h"

namespace hooke {

NeighbourGraph::NeighbourGraph(const Springs& springs, const Adjacency& adjacency, std::size_t particles) {
  constexpr Index none = ~Index{0};
  std::vector<Index> number(particles, none);
  user_.reserve(particles);
  begin_.reserve(particles + 1);
  neighbours_.reserve(adjacency.springs.size());
  const auto visit = [&](Index particle) {
    if (number[particle] != none) return;
    number[particle] = Index(user_.size());
    user_.push_back(particle);
  };
  for (Index first = 0; first < particles; ++first) {
    if (number[first] != none) continue;
    const auto part_begin = Index(user_.size());
    visit(first);
    for (std::size_t i = part_begin; i < user_.size(); ++i) {
      const Index particle = user_[i];
      begin_.push_back(neighbours_.size());
      for (std::size_t k = adjacency.begin[particle]; k < adjacency.begin[particle + 1]; ++k) {
        neighbours_.push_back(other_end(springs, adjacency.springs[k], particle));
        visit(neighbours_.back());
      }
    }
    parts_.push_back({part_begin, Index(user_.size())});
  }
  begin_.push_back(neighbours_.size());
  for (Index& neighbour : neighbours_) neighbour = number[neighbour];
}

}  // namespace hooke
