#pragma once

#include "aligned.h"
#include "sleep/awake_blocks.h"
#include "solve/supernodes.h"

namespace hooke {

/// A Cholesky factor L in the blocks of its supernodes, by rows: of the triangle on the diagonal the inverse
/// (whole, with the zeros above the diagonal), so that solving with it is a product, and of the rows below
/// the values themselves.
template <class Real>
struct BlockFactor {
  /// Values behind the last that vectors may read, and vectors of four behind a right-hand side.
  static constexpr std::size_t room = 64 / sizeof(Real);

  Supernodes supernodes;
  AlignedVector<Real> values;
  AwakeBlocks awake;  ///< nodes that are gone through: in the columns of the others right-hand sides are zero

  std::size_t bytes() const {
    return values.capacity() * sizeof(Real) + supernodes.rows.capacity() * sizeof(std::uint32_t) +
           supernodes.nodes.capacity() * sizeof(Supernode);
  }
};

/// Solves L L^T u = b in place for four right-hand sides at once: `sides` has four values for each row, those
/// of all sides together, so that each value of L is read once for all of them. Behind them lies
/// BlockFactor::room.
template <class Real>
void solve_triangles(const BlockFactor<Real>& factor, Real* sides);

}  // namespace hooke
