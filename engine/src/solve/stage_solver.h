#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <hooke/methods.h>
#include <hooke/report.h>
#include <hooke/scene.h>

#include "forces.h"
#include "model/model.h"

namespace hooke {

/// What an implicit method solves in a step: find the state with
///   x = from.x + h v,   v = from.v + h M^-1 f(x, v, time)
/// for the particles that are not pinned.
template <class Real>
struct ImplicitStage {
  const State<Real>& from;
  double h;     ///< [s] > 0
  double time;  ///< [s] at which forces are taken
};

/// How solving a stage went.
struct StageResult {
  std::uint64_t iterations = 0;         ///< of the solver
  std::uint64_t linear_iterations = 0;  ///< of linear solvers inside it
  std::uint64_t force_evaluations = 0;
  double residual = 0.0;  ///< change of positions of the last iteration, RMS over the scene's size [1]
  bool converged = true;  ///< to the method's tolerance; a method that has none always does
};

/// Solves the stages of implicit methods. It holds all the memory it needs: solving allocates nothing.
template <class Real>
class StageSolver {
 public:
  virtual ~StageSolver() = default;

  /// On entry `next` is the guess: velocities, positions from.x + h v, and pinned particles where they are at
  /// the stage's time, which stay so. On return it is the solution, packed copies included.
  virtual StageResult solve(const ImplicitStage<Real>& stage, State<Real>& next) = 0;

  /// Whether solve() does itself what effects do to strips of a result.
  virtual bool corrects_strips() const { return false; }

  /// Its name, what it reads and the bytes it holds. As of all stages, the plan says in which sweep.
  virtual Stage stage() const = 0;
};

/// What a solver is made of. All must outlive it.
template <class Real>
struct SolverContext {
  const Scene& scene;  ///< only while the solver is being made
  const Model<Real>& model;
  Forces<Real>& forces;
  Executor& executor;
};

template <class Real>
using StageSolverPointer = std::unique_ptr<StageSolver<Real>>;

/// The solver of a method; null for a method that solves nothing.
template <class Real>
StageSolverPointer<Real> make_stage_solver(const Method& method, const SolverContext<Real>& context);

}  // namespace hooke
