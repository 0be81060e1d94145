#pragma once

#include <vector>

#include "effects/compiled_effect.h"

namespace hooke {

/// The effects of a scene, compiled; for each thing that they do a list of those that do it, so that what
/// none does costs a look at an empty list.
template <class Real>
class EffectList {
 public:
  EffectList(const Scene& scene, const Model<Real>& model);

  bool calls_user() const;
  bool prepares() const { return !prepared_.empty(); }
  bool has_uncoupled_derivatives() const { return !uncoupled_derived_.empty(); }
  bool has_derivatives() const { return has_uncoupled_derivatives() || !coupled_derived_.empty(); }
  bool coupled() const { return !coupled_.empty(); }
  bool corrects_strips() const { return !strip_correctors_.empty(); }
  bool corrects() const { return !correctors_.empty(); }
  std::size_t reach() const;  ///< the most blocks from a particle to another one that its force depends on

  /// What the forces need of the whole state; before add_forces() and add_derivatives() of its strips.
  void prepare(const State<Real>& state, double time, Executor& executor) {
    for (CompiledEffect<Real>* effect : prepared_) effect->prepare(state, time, executor);
  }

  /// Adds the force [N] on the particles of a strip at `time` [s].
  void add_forces(const Strip<Real>& strip, double time, StripForce<Real>& force) const {
    for (const CompiledEffect<Real>* effect : forces_) effect->add_force(strip, time, force);
  }

  /// Adds the weighted derivative of the forces by a particle's own position and velocity, as far as they
  /// know it: of the effects that are not coupled, or of the coupled ones, or of these so much that it is at
  /// least their whole derivative.
  void add_uncoupled_derivatives(const Strip<Real>& strip, double time,
                                 const DerivativeWeights<Real>& weights, StripBlocks<Real>& blocks) const {
    for (const CompiledEffect<Real>* effect : uncoupled_derived_)
      effect->add_derivative(strip, time, weights, blocks);
  }
  void add_coupled_derivatives(const Strip<Real>& strip, double time, const DerivativeWeights<Real>& weights,
                               StripBlocks<Real>& blocks) const {
    for (const CompiledEffect<Real>* effect : coupled_derived_)
      effect->add_derivative(strip, time, weights, blocks);
  }
  void add_coupled_majorants(const Strip<Real>& strip, double time, const DerivativeWeights<Real>& weights,
                             StripBlocks<Real>& blocks) const;

  /// The two kinds of forces apart.
  void add_uncoupled_forces(const Strip<Real>& strip, double time, StripForce<Real>& force) const {
    for (const CompiledEffect<Real>* effect : uncoupled_) effect->add_force(strip, time, force);
  }
  void add_coupled_forces(const Strip<Real>& strip, double time, StripForce<Real>& force) const {
    for (const CompiledEffect<Real>* effect : coupled_) effect->add_force(strip, time, force);
  }

  /// What add_products() of strips needs of the whole state and direction.
  void prepare_products(const State<Real>& search, Executor& executor) {
    for (CompiledEffect<Real>* effect : coupled_) effect->prepare_product(search, executor);
  }

  /// Adds the coupled effects' weighted derivative times a direction: see CompiledEffect::add_product().
  void add_products(const Strip<Real>& search, const DerivativeWeights<Real>& weights, Curvature curvature,
                    StripForce<Real>& product) const {
    for (const CompiledEffect<Real>* effect : coupled_)
      effect->add_product(search, weights, curvature, product);
  }

  /// Changes the result of a step in place: the blocks [begin, end), with nothing else looked at.
  void correct_strips(const StepResult<Real>& result, std::size_t begin, std::size_t end) const {
    for (const CompiledEffect<Real>* effect : strip_correctors_) effect->correct_strip(result, begin, end);
  }

  /// Likewise all of it, after the strips.
  void correct(const StepResult<Real>& result, Executor& executor) {
    for (CompiledEffect<Real>* effect : correctors_) effect->correct(result, executor);
  }

  /// Adds what corrections of everything have met with since this was called last.
  void tell(Report& report) {
    for (CompiledEffect<Real>* effect : correctors_) effect->tell(report);
  }

  double energy(const Strip<Real>& strip) const;  ///< potential [J]

  std::size_t size() const { return effects_.size(); }
  const CompiledEffect<Real>& operator[](std::size_t effect) const { return *effects_[effect]; }

  /// Sums of carried forces begin anew.
  void forget_forces(State<Real>& state) const {
    for (const CompiledEffect<Real>* effect : carriers_) effect->forget_forces(state);
  }

  /// See CompiledEffect.
  void frames_changed() {
    for (const EffectPointer<Real>& effect : effects_) effect->frames_changed();
  }
  bool leads(Index particle) const;
  void note_touches(const State<Real>& state, Executor& executor, Islands& islands) {
    for (const EffectPointer<Real>& effect : effects_) effect->note_touches(state, executor, islands);
  }
  void disturb(double from, double to, Disturbances& disturbed) const {
    for (const EffectPointer<Real>& effect : effects_) effect->disturb(from, to, disturbed);
  }
  void pins_moved(const State<Real>& state) {
    for (const EffectPointer<Real>& effect : effects_) effect->pins_moved(state);
  }

  /// State::memory at the start.
  const std::vector<Real>& initial_memory() const { return initial_memory_; }

  /// The number of lists of State::pairs.
  std::size_t pair_lists() const { return pair_keepers_.size(); }

  /// Of what is done before forces; of forces and what is done to strips; of the corrections of everything.
  std::vector<Stage> preparation_stages() const;
  std::vector<Stage> strip_stages() const;
  std::vector<Stage> correction_stages() const;

 private:
  using Some = std::vector<CompiledEffect<Real>*>;

  /// Those that do this, and do not do that.
  Some with(unsigned parts, unsigned without = 0) const;
  void share_out_memory();

  std::vector<EffectPointer<Real>> effects_;
  Some forces_, uncoupled_, coupled_, prepared_, uncoupled_derived_, coupled_derived_, strip_correctors_,
      correctors_, carriers_, pair_keepers_;
  std::vector<Real> initial_memory_;
};

}  // namespace hooke
