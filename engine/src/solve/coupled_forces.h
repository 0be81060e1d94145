#pragma once

#include <optional>

#include "solve/particle_blocks.h"
#include "solve/particle_vectors.h"
#include "solve/stage_solver.h"

namespace hooke {

/// The forces of coupled effects for methods that move one particle after the other, or each alone: they are
/// taken in one state for all particles, with matrices for each alone that are together at least the whole
/// derivative, so that all can move at once and none too far. Without such effects it holds nothing.
template <class Real>
class CoupledForces {
 public:
  CoupledForces(const Model<Real>& model, Forces<Real>& forces);

  /// Whether take() must be called before add(), and before uncoupled forces are asked for.
  bool any() const { return any_; }

  /// Takes them in a state, at a time [s]. `weights` are those of the matrices.
  void take(const State<Real>& state, double time, const DerivativeWeights<Real>& weights,
            Executor& executor);

  /// Adds what was taken for the particles of a strip.
  void add(std::size_t begin_block, std::size_t end_block, StripForce<Real>& force,
           StripBlocks<Real>& blocks) const;

  std::size_t bytes() const { return taken_ ? taken_->forces.bytes() + taken_->blocks.bytes() : 0; }

 private:
  struct Taken {
    explicit Taken(std::size_t particles) : forces(particles), blocks(particles) {}

    ParticleVectors<Real> forces;  // [N]
    ParticleBlocks<Real> blocks;
  };

  const Model<Real>& model_;
  EffectList<Real>& effects_;
  bool any_;
  std::optional<Taken> taken_;
};

}  // namespace hooke
