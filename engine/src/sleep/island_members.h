#pragma once

#include <span>
#include <vector>

#include "model/order.h"
#include "sleep/islands.h"

namespace hooke {

/// Particles of a scene, island by island.
class IslandMembers {
 public:
  IslandMembers() = default;

  /// Of particles in the engine's order; those of an island stay in the order in which they are given.
  IslandMembers(const Islands& islands, const Order& order, std::span<const Index> particles);

  std::span<const Index> of(Index island) const {
    return std::span(particles_).subspan(begin_[island], begin_[island + 1] - begin_[island]);
  }

  std::size_t bytes() const {
    return particles_.capacity() * sizeof(Index) + begin_.capacity() * sizeof(std::size_t);
  }

 private:
  std::vector<Index> particles_;
  std::vector<std::size_t> begin_;  ///< of each island in them; one more than there are islands
};

}  // namespace hooke
