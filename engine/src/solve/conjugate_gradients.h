#pragma once

#include "solve/descent.h"

namespace hooke {

/// Newton's directions: solves with A = M + h C + h^2 K, where K and C are the force derivatives in the state
/// that is given, those of pressed springs without the negative stiffness across them. A is never assembled:
/// conjugate gradients (Hestenes and Stiefel 1952) need only products with it, which the slots give. They are
/// preconditioned by the 3x3 block of each particle.
///
/// The nearer the descent is to its end, the more exactly a direction is found (Eisenstat and Walker 1996).
template <class Real>
std::unique_ptr<DirectionSolver<Real>> make_conjugate_gradients(const SolverContext<Real>& context);

}  // namespace hooke
