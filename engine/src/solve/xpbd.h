#pragma once

#include "solve/stage_solver.h"

namespace hooke {

template <class Real>
StageSolverPointer<Real> make_stage_solver(const Xpbd& method, const SolverContext<Real>& context);

}  // namespace hooke
