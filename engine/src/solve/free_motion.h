#pragma once

#include <cstdint>

#include "forces.h"
#include "model/model.h"
#include "solve/coupled_forces.h"
#include "solve/stage_solver.h"

namespace hooke {

/// What particles do in a substep but for springs: they go on with their velocities and the forces of
/// effects; pins go along a straight line from where they are at the step's start to where its end has them.
template <class Real>
class FreeMotion {
 public:
  FreeMotion(const Model<Real>& model, Forces<Real>& forces);

  /// One of equal parts of a step.
  struct Substep {
    const ImplicitStage<Real>& stage;
    const State<Real>& end;  ///< of the step: where pins are then
    Real h;                  ///< [s]
    double left;             ///< of the step after this part, as a share of it [1]
    bool first;
  };

  /// Whether take_coupled() must be called for all particles between begin() and add_effects().
  bool coupled() const { return coupled_.any(); }

  /// For a run of blocks: where particles get to by the end of the substep without any forces.
  void begin(const Substep& substep, std::size_t begin, std::size_t end);

  void take_coupled(const Substep& substep, Executor& executor);

  /// For a run of blocks: then positions and velocities as if there were no springs, as a step of backward
  /// Euler from where the last substep ended. Effects are taken where particles get without them, with their
  /// derivatives there, so that a stiff ground or a strong drag does no harm.
  void add_effects(const Substep& substep, std::size_t begin, std::size_t end);

  /// For a run of blocks: adds the packed vectors `moves` [m] to where free particles are, and what takes
  /// them there to their velocities.
  void correct(Real h, const Real* moves, std::size_t begin, std::size_t end);

  /// For a run of blocks: then what effects do to strips of a result, as if the substep were a step.
  void correct_strips(const Substep& substep, std::size_t begin, std::size_t end);

  const State<Real>& start() const { return start_; }  ///< of the substep
  const State<Real>& now() const { return now_; }

  std::size_t bytes() const { return start_.bytes() + now_.bytes() + coupled_.bytes(); }

 private:
  void begin_block(const Substep& substep, std::size_t block);
  void add_effects_to_strip(const Substep& substep, std::size_t begin, std::size_t end);

  static double time_of(const Substep& substep) {
    return substep.stage.time - substep.left * substep.stage.h;
  }
  static DerivativeWeights<Real> weights_of(const Substep& substep) {
    return {substep.h * substep.h, substep.h};
  }

  const Model<Real>& model_;
  Forces<Real>& forces_;
  CoupledForces<Real> coupled_;
  State<Real> start_, now_;
  std::uint64_t islands_seen_ = 0;
};

}  // namespace hooke
