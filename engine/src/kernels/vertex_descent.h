#pragma once

#include "force_derivative.h"
#include "model/row_store.h"
#include "model/slots.h"
#include "state.h"
#include "strip.h"

namespace hooke {

/// The equations of a step, of which each particle solves its own three:
///   A dv = from.v - v + h f / m,   A = I + (h^2 K + h C) / m
/// with the forces f of its springs and the derivatives K and C of these by its own position and velocity.
/// Stiffness across a spring, k (1 - l0 / l), is taken as `least_across` k where it is less: 0 keeps pressed
/// springs positive definite (Choi and Ko 2002); with 1 no step can raise the potential of the step, as
/// k |d|^2 / 2 bends as much as the spring's energy or more (Liu et al. 2013).
template <class Real>
struct VertexEquations {
  const Slots<Real>* slots;  ///< with both ends of each spring; null where there are no springs
  const BlockRows<Real>& inverse_mass;
  const State<Real>& from;
  Real h;             ///< [s]
  Real least_across;  ///< in [0, 1]
};

/// Particles of one colour: [first, last) in the blocks [begin, end), at most strip_blocks of them. Others
/// that share the first or last block are left alone.
struct VertexStrip {
  std::size_t begin, end, first, last;
};

/// Solves the equations of each particle of a strip, which none of the others of its colour is joined to:
/// v += dv, x = from.x + h v. `force` and `blocks` are the effects', the blocks weighted with h^2 and h. Both
/// are of the strip's blocks. Returns the sum of |dv|^2.
template <class Real>
double solve_vertices(const VertexEquations<Real>& equations, const VertexStrip& strip,
                      const StripForce<Real>& force, const StripBlocks<Real>& blocks, State<Real>& now);

}  // namespace hooke
