#pragma once

#include <vector>

#include "effects/effect_list.h"
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

  const EffectList<Real>& effects() const { return effects_; }
  EffectList<Real>& effects() { return effects_; }

  /// Whether something must be done for the whole state before on_strip(): prepare().
  bool needs_preparation() const { return scatters() || effects_.prepares(); }

  /// Adds up the scattered springs' forces, which on_strip() then takes, so it must be called for every
  /// block; and what effects need of the whole state.
  void prepare(const State<Real>& state, double time, Executor& executor);

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
    effects_.add_forces(strip, time, force);
  }

  /// Forgets sums that no block took, after a step that was broken off.
  void clear() { sums_.clear(); }

  SpringMeasure measure_springs(const State<Real>& state, Executor& executor) const;

  /// What prepare() does. As of all stages here, the plan says in which sweep.
  std::vector<Stage> preparation_stages() const;

  /// What on_strip() does: gathered springs, and effects.
  std::vector<Stage> strip_stages() const;

  /// How the springs are laid out, in words; empty where there are none.
  std::string spring_layout() const;

 private:
  Stage spring_stage() const;  ///< the springs, of which there must be some
  void scatter(const State<Real>& state, Executor& executor);

  const Model<Real>& model_;
  std::size_t springs_ = 0;                       ///< in the slots
  const Slots<Real>* slots_ = nullptr;            ///< null where there are no springs but cables
  const SpringBatches<Real>* batches_ = nullptr;  ///< of the modes that scatter, else null
  ForceSums<Real> sums_;
  EffectList<Real> effects_;
};

}  // namespace hooke
