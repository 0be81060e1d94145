#pragma once

#include <cstddef>
#include <vector>

#include "model/adjacency.h"
#include "model/order.h"

namespace hooke {

/// The particles colour by colour, so that no spring joins two of one colour.
struct VertexColours {
  Order order;                     ///< all particles, those of each colour behind one another
  std::vector<std::size_t> begin;  ///< where each colour begins in it; one more than there are colours

  std::size_t colours() const { return begin.size() - 1; }
};

/// Where springs join particles a few fixed distances apart in `engine`, as in a grid, the colour of a
/// particle is its number modulo the least count that does. Neighbours of consecutive particles of one
/// colour are then consecutive particles of another one, which vectors load as they lie. Otherwise each
/// particle, in the order given, gets the first colour that none of its neighbours has.
VertexColours colour_vertices(const Springs& springs, const Adjacency& adjacency, const Order& engine);

}  // namespace hooke
