#pragma once

#include <cstddef>
#include <vector>

#include "model/order.h"

namespace hooke {

/// Springs colour by colour, so that no two of one colour share a particle.
struct SpringColours {
  std::vector<Index> springs;
  std::vector<std::size_t> begin;  ///< where each colour begins in it; one more than there are colours

  std::size_t colours() const { return begin.size() - 1; }
};

/// Each spring but those that do nothing, by the lower of its ends in `engine`, gets the first colour that no
/// other spring at its ends has; in each colour they stay in that order, so that ends lie near in memory.
SpringColours colour_springs(const Springs& springs, const Order& engine);

/// Likewise of those that are chosen, whatever they do.
SpringColours colour_springs(const Springs& springs, const Order& engine, std::vector<Index> chosen);

}  // namespace hooke
