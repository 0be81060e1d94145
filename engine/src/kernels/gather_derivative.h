#pragma once

#include "force_derivative.h"
#include "model/slots.h"
#include "strip.h"

namespace hooke {

/// What is taken for the stiffness of a spring across its direction, k (1 - l0 / l), where it is pressed and
/// so negative.
enum class PressedSprings {
  exact,   ///< as it is
  no_push  ///< zero: the derivative has no negative eigenvalues (Choi and Ko 2002)
};

/// Multiplies the weighted derivative of all springs' forces by a direction: for the particles of the blocks
/// [begin, end), at most strip_blocks of them, the sum over their springs to j of
///   (w_k K + w_c C) (p_i - p_j),  K = k n n^T + k (1 - l0 / l) (I - n n^T),  C = c n n^T
/// with n the unit vector along the spring. Of dampers the derivative by positions is left out. `state` has
/// positions x, and the direction p in place of velocities; both in packed copies where there are indexed
/// slots. `product` is set. Slots have both ends of springs.
template <class Real>
void gather_product(const Slots<Real>& slots, const State<Real>& state, std::size_t begin, std::size_t end,
                    const DerivativeWeights<Real>& weights, PressedSprings pressed,
                    StripForce<Real>& product);

/// Sets `blocks` to the sums over each particle's springs of w_k K + w_c C: what the derivative has on its
/// diagonal. Velocities of `state` are not looked at, but must be there in packed copies as above.
template <class Real>
void gather_diagonal(const Slots<Real>& slots, const State<Real>& state, std::size_t begin, std::size_t end,
                     const DerivativeWeights<Real>& weights, PressedSprings pressed,
                     StripBlocks<Real>& blocks);

}  // namespace hooke
