#include <type_traits>
#include <utility>

#include "solve/conjugate_gradients.h"
#include "solve/constant_stiffness.h"
#include "solve/descent.h"
#include "solve/vertex_block_descent.h"
#include "solve/xpbd.h"

namespace hooke {
namespace {

/// Of a method that solves nothing there is none.
template <class Real, class Explicit>
StageSolverPointer<Real> solver_of(const Explicit&, const SolverContext<Real>&) {
  return nullptr;
}

template <class Real, class Newton>
StageSolverPointer<Real> newton(const Newton& method, const SolverContext<Real>& context) {
  return make_descent<Real>(Newton::name, {method.tolerance, method.most_iterations},
                            make_conjugate_gradients<Real>(context), context);
}

template <class Real>
StageSolverPointer<Real> solver_of(const BackwardEuler& method, const SolverContext<Real>& context) {
  return newton(method, context);
}

template <class Real>
StageSolverPointer<Real> solver_of(const ImplicitMidpoint& method, const SolverContext<Real>& context) {
  return newton(method, context);
}

template <class Real>
StageSolverPointer<Real> solver_of(const Bdf2& method, const SolverContext<Real>& context) {
  return newton(method, context);
}

template <class Real>
StageSolverPointer<Real> solver_of(const ProjectiveDynamics& method, const SolverContext<Real>& context) {
  DescentLimits limits{method.tolerance, method.iterations};
  if (method.history == 0) limits.furthest = 1.0;  // as it was published
  return make_descent<Real>(ProjectiveDynamics::name, limits,
                            make_constant_stiffness<Real>(context, method.history), context);
}

template <class Real>
StageSolverPointer<Real> solver_of(const Xpbd& method, const SolverContext<Real>& context) {
  return make_stage_solver(method, context);
}

template <class Real>
StageSolverPointer<Real> solver_of(const VertexBlockDescent& method, const SolverContext<Real>& context) {
  return make_stage_solver(method, context);
}

}  // namespace

template <class Real>
StageSolverPointer<Real> make_stage_solver(const Method& method, const SolverContext<Real>& context) {
  return std::visit([&](const auto& one) { return solver_of<Real>(one, context); }, method);
}

template StageSolverPointer<float> make_stage_solver(const Method&, const SolverContext<float>&);
template StageSolverPointer<double> make_stage_solver(const Method&, const SolverContext<double>&);

}  // namespace hooke
