#pragma once

#include <limits>

#include "solve/particle_vectors.h"
#include "solve/stage_solver.h"

namespace hooke {

/// Finds directions for a descent: approximate solutions dv of
///   A dv = r,   r = M (from.v - v) + h f(x, v, time)
/// with A = M + h C + h^2 K, or a positive definite matrix like it, for the particles that are not pinned;
/// r and dv are 0 where they are.
template <class Real>
class DirectionSolver {
 public:
  virtual ~DirectionSolver() = default;

  struct Result {
    std::uint64_t iterations = 0;
  };

  /// Another stage begins.
  virtual void begin() {}

  /// How far the last direction led, in tolerances: where it was far, the next one need not be found so
  /// exactly.
  virtual void note_change(double /*tolerances*/) {}

  /// `at` is the state whose residual is given, and which the forces have been prepared for.
  virtual Result solve(const ImplicitStage<Real>& stage, const State<Real>& at,
                       const ParticleVectors<Real>& residual, ParticleVectors<Real>& direction) = 0;

  /// Bytes that it holds.
  virtual std::size_t bytes() const = 0;
};

/// When a descent ends.
struct DescentLimits {
  double tolerance;               ///< change of positions, RMS over the scene's size [1]; 0: there is none
  std::uint64_t most_iterations;  ///< >= 1
  double furthest = std::numeric_limits<double>::infinity();  ///< along a direction, over its length; >= 1
};

/// Newton's method and its like: goes along directions as long as the incremental potential
///   1/2 (v - from.v) M (v - from.v) + E(from.x + h v)
/// falls, until a step is no longer than the tolerance. `name` is the method's.
template <class Real>
StageSolverPointer<Real> make_descent(std::string_view name, const DescentLimits& limits,
                                      std::unique_ptr<DirectionSolver<Real>> directions,
                                      const SolverContext<Real>& context);

}  // namespace hooke
