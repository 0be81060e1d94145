#pragma once

#include <vector>

#include <hooke/scene.h>

#include "model/order.h"

namespace hooke {

/// A pair of a stitch within its knot. Those in the tree lead from a child to a parent nearer to its root.
struct KnotPair {
  std::size_t number;                     ///< in the stitch
  Index child, parent;                    ///< in the engine's order
  std::size_t child_place, parent_place;  ///< in Knots::particles
  double distance;                        ///< at the start [m]
  bool child_is_first;                    ///< of the pair
  bool in_tree;                           ///< else it closes a ring
};

/// Particles that pairs join, directly or by others between.
struct Knot {
  std::size_t first_particle, last_particle;  ///< in Knots::particles
  std::size_t first_pair, last_pair;          ///< in Knots::pairs
};

/// The knots of a stitch. The root of a knot is its particle that is pinned, attached or scripted, where it
/// has one; pairs come from the ends of the tree to its root.
struct Knots {
  Knots(const Stitch& stitch, const Scene& scene, const Order& order);

  std::vector<Knot> knots;
  std::vector<Index> particles;  ///< in the engine's order, knot by knot
  std::vector<KnotPair> pairs;   ///< knot by knot

  std::size_t bytes() const {
    return knots.capacity() * sizeof(Knot) + particles.capacity() * sizeof(Index) +
           pairs.capacity() * sizeof(KnotPair);
  }
};

/// For each particle of the user's numbering the lowest one that it is sewn to, itself included.
std::vector<Index> knot_roots(const Stitch& stitch, std::size_t particles);

}  // namespace hooke
