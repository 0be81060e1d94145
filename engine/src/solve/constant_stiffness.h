#pragma once

#include "solve/descent.h"

namespace hooke {

/// Directions of projective dynamics (Liu et al. 2013): solves with the matrix of SpringLaplacian and a
/// diagonal of the effects. In no state do springs have more stiffness than it has, so each direction leads
/// to a lower potential; and it stays the same from step to step, so it is factored once, with the effects as
/// they are in the scene's first state. Where they are stiffer in a stage, as at contact with the ground,
/// that is made up for without another factor (ChangedDiagonal).
///
/// With `secant_pairs` > 0, directions are bettered by what so many iterations before them told of the true
/// matrix (SecantPairs).
template <class Real>
std::unique_ptr<DirectionSolver<Real>> make_constant_stiffness(const SolverContext<Real>& context,
                                                               std::size_t secant_pairs);

}  // namespace hooke
