#pragma once

#include <vector>

#include "forces.h"
#include "model/model.h"
#include "solve/lane_sums.h"
#include "solve/particle_vectors.h"
#include "solve/stage_solver.h"

namespace hooke {

/// What the equations of implicit stages lack of being solved: M (from.v - v) + h f(x, v, time) [kg m/s], 0
/// where particles are pinned or asleep.
template <class Real>
class Residual {
 public:
  explicit Residual(const SolverContext<Real>& context);

  /// Writes it for the state `at`, and returns its dot product with `direction`.
  double evaluate(const ImplicitStage<Real>& stage, const State<Real>& at,
                  const ParticleVectors<Real>& direction);

  const ParticleVectors<Real>& values() const { return values_; }
  const BlockRows<Real>& mass() const { return mass_; }  ///< [kg]; 0 where pinned, and in the padding
  std::size_t bytes() const { return values_.bytes() + mass_.bytes(); }

 private:
  const Model<Real>& model_;
  Forces<Real>& forces_;
  Executor& executor_;
  BlockRows<Real> mass_;
  ParticleVectors<Real> values_;
  std::vector<DotSum> sums_;
  std::uint64_t islands_seen_ = 0;
};

}  // namespace hooke
