#pragma once

#include <vector>

#include "block.h"
#include "effects/block_effect.h"
#include "kernels/gather.h"
#include "kernels/scatter.h"
#include "model/model.h"

namespace hooke {

/// All forces of a scene: its springs in their accumulation mode and its effects, and nothing that it does
/// not name. Springs that are scattered are accumulated first, over all particles; the rest happens block by
/// block.
template <class Real>
class Forces {
 public:
  Forces(const Scene& scene, const Model<Real>& model, Accumulation accumulation);

  bool scatters() const { return list_ != nullptr; }

  /// Adds up the scattered springs' forces; on_block() then takes them, so it must be called for every block.
  void scatter(const State<Real>& state, Executor& executor);

  /// The whole force [N] on the particles of a block.
  void on_block(std::size_t block, const State<Real>& state, BlockForce<Real>& force) {
    if (slots_ != nullptr) {
      gather_springs(*slots_, state, block, force);
    } else if (list_ != nullptr) {
      sums_.take(block, force);
    } else {
      force = BlockForce<Real>{};
    }
    const Block<Real> particles(state, block);
    for (const BlockEffectPointer<Real>& effect : effects_) effect->add_force(particles, state.time, force);
  }

  /// Forgets sums that no block took, after a step that was broken off.
  void clear();

  SpringMeasure measure_springs(const State<Real>& state, Executor& executor) const;

  /// Potential energy [J] of the effects on a block.
  double effect_energy(const Block<Real>& block) const;

  /// The springs, of which there must be some. As of all stages here, the plan says in which sweep.
  Stage spring_stage() const;

  /// What on_block() does: gathered springs, and effects.
  std::vector<Stage> block_stages() const;

  /// How the springs are laid out, in words; empty where there are none.
  std::string spring_layout() const;

 private:
  const Slots<Real>* slots_ = nullptr;
  const SpringList<Real>* list_ = nullptr;
  Adds adds_ = Adds::plain;
  ForceArrays<Real> sums_;
  std::vector<BlockEffectPointer<Real>> effects_;
};

}  // namespace hooke
