#pragma once

#include <vector>

#include "effects/strip_effect.h"
#include "kernels/gather.h"
#include "kernels/scatter.h"
#include "model/model.h"
#include "strip.h"

namespace hooke {

/// All forces of a scene: its springs in their accumulation mode and its effects, and nothing that it does
/// not name. Springs that are scattered are accumulated first, over all particles; the rest happens block by
/// block.
template <class Real>
class Forces {
 public:
  Forces(const Scene& scene, const Model<Real>& model);

  bool scatters() const { return batches_ != nullptr; }

  /// Whether one of the effects calls a function of the user's, which may expect to be asked for one time
  /// after the other.
  bool calls_user() const;

  /// Adds up the scattered springs' forces; on_strip() then takes them, so it must be called for every block.
  void scatter(const State<Real>& state, Executor& executor);

  /// The whole force [N] on the particles of a strip at `time` [s].
  void on_strip(const Strip<Real>& strip, const State<Real>& state, double time, StripForce<Real>& force) {
    const std::size_t begin = strip.first / block_size, end = begin + strip.lanes / block_size;
    if (batches_ != nullptr) {
      take_sums(strip, sums_, force);
    } else if (slots_ != nullptr) {
      gather_springs(*slots_, state, begin, end, force);
    } else {
      force = StripForce<Real>{};
    }
    add_effects(strip, time, force);
  }

  /// Adds the effects' force [N] on the particles of a strip at `time` [s], without the springs'.
  void add_effects(const Strip<Real>& strip, double time, StripForce<Real>& force) const {
    for (const StripEffectPointer<Real>& effect : effects_) effect->add_force(strip, time, force);
  }

  bool has_effect_derivatives() const;

  /// Adds the weighted derivative of the effects' force, as far as they know it (StripEffect).
  void add_effect_derivatives(const Strip<Real>& strip, const DerivativeWeights<Real>& weights,
                              StripBlocks<Real>& blocks) const {
    for (const StripEffectPointer<Real>& effect : effects_) effect->add_derivative(strip, weights, blocks);
  }

  /// Forgets sums that no block took, after a step that was broken off.
  void clear() { sums_.clear(); }

  SpringMeasure measure_springs(const State<Real>& state, Executor& executor) const;

  /// Potential energy [J] of the effects on a strip.
  double effect_energy(const Strip<Real>& strip) const;

  /// The springs, of which there must be some. As of all stages here, the plan says in which sweep.
  Stage spring_stage() const;

  /// What on_strip() does: gathered springs, and effects.
  std::vector<Stage> strip_stages() const;

  /// How the springs are laid out, in words; empty where there are none.
  std::string spring_layout() const;

 private:
  std::size_t springs_ = 0;
  const Slots<Real>* slots_ = nullptr;            ///< of all springs; null where there are none
  const SpringBatches<Real>* batches_ = nullptr;  ///< of the modes that scatter, else null
  ForceSums<Real> sums_;
  std::vector<StripEffectPointer<Real>> effects_;
};

}  // namespace hooke
