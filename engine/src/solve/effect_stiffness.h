#pragma once

#include <vector>

#include "force_derivative.h"
#include "solve/stage_solver.h"

namespace hooke {

/// How stiff the effects on each particle have been at most since clear(): bounds on the largest eigenvalues
/// of their weighted derivatives, for each of the engine's particles.
template <class Real>
class EffectStiffness {
 public:
  explicit EffectStiffness(const SolverContext<Real>& context);

  void clear();

  /// Adds what they are in a state, which the forces have been prepared for, at a time [s].
  void add(const State<Real>& at, double time, const DerivativeWeights<Real>& weights);

  const std::vector<Real>& bounds() const { return bounds_; }

  std::size_t bytes() const { return bounds_.capacity() * sizeof(Real); }

 private:
  const Model<Real>& model_;
  const Forces<Real>& forces_;
  std::vector<Real> bounds_;
};

}  // namespace hooke
