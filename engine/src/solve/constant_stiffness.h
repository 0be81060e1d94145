#pragma once

#include "solve/descent.h"

namespace hooke {

/// Directions of projective dynamics (Liu et al. 2013): solves with the matrix of SpringLaplacian and what
/// the effects add to its diagonal. In no state do springs have more stiffness than it has, so each direction
/// leads to a lower potential; and it stays the same from step to step, so it is factored once. It is
/// factored again where the step changes, and where the effects of a particle become stiffer in a stage than
/// the matrix knows, as at contact with the ground.
///
/// With `secant_pairs` > 0, directions are bettered by what so many iterations before them told of the true
/// matrix (SecantPairs).
template <class Real>
std::unique_ptr<DirectionSolver<Real>> make_constant_stiffness(const SolverContext<Real>& context,
                                                               std::size_t secant_pairs);

}  // namespace hooke
