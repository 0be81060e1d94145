#pragma once

#include "forces.h"
#include "model/model.h"
#include "solve/stage_solver.h"

namespace hooke {

/// What particles do in a substep but for springs: they go on with their velocities and the forces of
/// effects; pins go along a straight line from where they are at the step's start to where its end has them.
template <class Real>
class FreeMotion {
 public:
  FreeMotion(const Model<Real>& model, const Forces<Real>& forces);

  /// One of equal parts of a step.
  struct Substep {
    const ImplicitStage<Real>& stage;
    const State<Real>& end;  ///< of the step: where pins are then
    Real h;                  ///< [s]
    double left;             ///< of the step after this part, as a share of it [1]
    bool first;
  };

  /// For a run of blocks: positions and velocities at the end of the substep if there were no springs, as a
  /// step of backward Euler from where the last substep ended. Effects are taken where particles get without
  /// them, with their derivatives there, so that a stiff ground or a strong drag does no harm.
  void predict(const Substep& substep, std::size_t begin, std::size_t end);

  /// For a run of blocks: adds the packed vectors `moves` [m] to where free particles are, and what takes
  /// them there to their velocities.
  void correct(Real h, const Real* moves, std::size_t begin, std::size_t end);

  const State<Real>& start() const { return start_; }  ///< of the substep
  const State<Real>& now() const { return now_; }

  std::size_t bytes() const { return start_.bytes() + now_.bytes(); }

 private:
  void begin_substep(const Substep& substep, std::size_t block);
  void add_effects(const Substep& substep, std::size_t begin, std::size_t end);

  const Model<Real>& model_;
  const Forces<Real>& forces_;
  State<Real> start_, now_;
};

}  // namespace hooke
