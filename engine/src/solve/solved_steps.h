#pragma once

#include <optional>

#include "solve/stage_solver.h"
#include "state_ring.h"

namespace hooke {

/// The steps of a method that solves equations: what of a step is one implicit stage, and how the step goes
/// on from its solution.
template <class Real>
class SolvedSteps {
 public:
  SolvedSteps(const Method& method, const SolverContext<Real>& context);

  /// Computes the step of `h` [s] from the newest state of the ring, at `time` [s], into the one after it,
  /// which will be at `time_after` [s]; leaves it to the caller to advance the ring. Returns how it went.
  StageResult take(double h, double time, double time_after, StateRing<Real>& states);

  /// The lowest number, in the user's numbering, of a particle in the state after the newest with a value
  /// that is not finite; Report::none if there is no such.
  Index first_bad(StateRing<Real>& states) const;

  /// The newest state, or the step, has been changed from outside: the one before is of no use.
  void forget() { knows_before_ = false; }

  /// Whether a step reads the state before the newest, and that there is one to read.
  bool uses_before() const { return kind_ == Kind::two_steps; }
  bool knows_before() const { return knows_before_; }

  /// The state before the newest has been given back.
  void remember() { knows_before_ = uses_before(); }

  /// The solver's, with all bytes that steps hold.
  Stage stage() const;

 private:
  enum class Kind { end, middle, two_steps };

  static Kind kind_of(const Method& method);

  StageResult take_end(double h, double time_after, const State<Real>& now, State<Real>& next);
  StageResult take_middle(double h, double time, double time_after, const State<Real>& now,
                          State<Real>& next);
  StageResult take_two_steps(double h, double time_after, const StateRing<Real>& states, State<Real>& next);

  /// visit(particle) for all that blocks of awake ones have, in the engine's order.
  template <class Visit>
  void for_each_awake(const Visit& visit) const;

  /// Sets `next` to the guess of a stage: the velocities of now, and pins where they are at its time.
  void guess(const ImplicitStage<Real>& stage, const State<Real>& now, State<Real>& next) const;

  /// Gives particles that attachments hold the velocities that forces, as they are after a stage, would give
  /// them in a time of `kick` [s]: what a frame takes of these is what it carries.
  void release(const ImplicitStage<Real>& stage, double kick, State<Real>& next);

  /// What effects do to the result of a step.
  void correct(double h, double time_after, const State<Real>& now, State<Real>& next);

  Kind kind_;
  const Model<Real>& model_;
  Forces<Real>& forces_;
  EffectList<Real>& effects_;
  Executor& executor_;
  StageSolverPointer<Real> solver_;
  std::optional<State<Real>> from_;  ///< of two steps, where the stage begins
  bool knows_before_ = false;
  std::vector<Vec3> pulls_;  ///< on particles that attachments hold [N]
};

}  // namespace hooke
