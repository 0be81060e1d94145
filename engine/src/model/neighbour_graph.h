#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <hooke/scene.h>

#include "model/adjacency.h"

namespace hooke {

/// Which particles springs join, numbered breadth-first, one connected part after the other. Neighbours so
/// lie near in memory: walks through the graph are several times as fast as in the user's numbering, if that
/// is random. Only while a scene is compiled.
class NeighbourGraph {
 public:
  /// The numbers of a connected part: from `begin` up to `end`.
  struct Part {
    Index begin, end;
  };

  NeighbourGraph(const Springs& springs, const Adjacency& adjacency, std::size_t particles);

  std::size_t size() const { return user_.size(); }
  Index user(Index i) const { return user_[i]; }
  std::span<const Index> neighbours(Index i) const {
    return {neighbours_.data() + begin_[i], neighbours_.data() + begin_[i + 1]};
  }
  const std::vector<Part>& parts() const { return parts_; }

 private:
  std::vector<Index> user_;
  std::vector<std::size_t> begin_;  ///< where each one's neighbours begin; one more than there are particles
  std::vector<Index> neighbours_;
  std::vector<Part> parts_;
};

}  // namespace hooke
