#pragma once

#include <optional>
#include <span>
#include <vector>

#include <hooke/effects.h>

#include "effects/effect_list.h"
#include "model/model.h"
#include "state.h"

namespace hooke {

/// The negative derivative K of the forces of springs, ground planes and coupled effects by positions, in one
/// state, as M^-1/2 K M^-1/2: its eigenvalues are the squares of the angular frequencies [1/s^2] of small
/// oscillations about that state; negative ones are directions in which pressed springs buckle. Computed in
/// double from the springs themselves, whatever the precision and the accumulation mode of the run; what
/// coupled effects add to it is in the run's precision.
///
/// A vector has x, y, z of each particle, in the engine's order.
template <class Real>
class ScaledStiffness {
 public:
  /// All must live as long as this does. The effects are prepared for the state, and stay so.
  ScaledStiffness(const Model<Real>& model, std::span<const GroundPlane> grounds, EffectList<Real>& effects,
                  const State<Real>& state, Executor& executor);

  /// out = M^-1/2 K M^-1/2 in.
  void multiply(std::span<const double> in, std::span<double> out);

  /// Of each entry of a vector 1 / sqrt(mass) [kg^-1/2], 0 where the particle is pinned.
  std::span<const double> inverse_roots() const { return inverse_roots_; }

 private:
  void multiply_block(std::size_t block, std::span<const double> in, std::span<double> out) const;
  void add_coupled(std::span<const double> in, std::span<double> out);
  Vec3 ground_product(std::size_t particle, const Vec3& moved) const;

  const Model<Real>& model_;
  std::span<const GroundPlane> grounds_;
  EffectList<Real>& effects_;
  const State<Real>& state_;
  Executor& executor_;
  std::optional<State<Real>>
      search_;  // the state, with a direction in place of velocities; of coupled effects
  std::vector<double> inverse_roots_;
};

}  // namespace hooke
