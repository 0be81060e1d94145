#include "solve/effect_stiffness.h"

#include <algorithm>
#include <cmath>

namespace hooke {
namespace {

/// At least the largest eigenvalue of a matrix that has no negative one: its trace, or its largest sum of a
/// row, whichever is less. The first is it for a push in one direction, the second for drag in all.
template <class Real>
Real largest_eigenvalue_bound(const StripBlocks<Real>& m, std::size_t i) {
  const Real xy = std::abs(m.xy[i]), xz = std::abs(m.xz[i]), yz = std::abs(m.yz[i]);
  const Real row = std::max({m.xx[i] + xy + xz, xy + m.yy[i] + yz, xz + yz + m.zz[i]});
  return std::min(m.xx[i] + m.yy[i] + m.zz[i], row);
}

}  // namespace

template <class Real>
EffectStiffness<Real>::EffectStiffness(const SolverContext<Real>& context)
    : model_(context.model),
      forces_(context.forces),
      bounds_(context.forces.effects().has_derivatives() ? context.model.particles() : 0, Real(0)) {}

template <class Real>
void EffectStiffness<Real>::clear() {
  std::fill(bounds_.begin(), bounds_.end(), Real(0));
}

template <class Real>
void EffectStiffness<Real>::add(const State<Real>& at, double time, const DerivativeWeights<Real>& weights) {
  if (bounds_.empty()) return;
  model_.for_each_awake_strip(0, block_count(at.size()), [&](std::size_t begin, std::size_t end) {
    const Strip<Real> strip(at, begin, end);
    StripBlocks<Real> blocks{};
    forces_.effects().add_uncoupled_derivatives(strip, time, weights, blocks);
    forces_.effects().add_coupled_majorants(strip, time, weights, blocks);
    for (std::size_t i = 0; i < strip.particles; ++i) {
      Real& bound = bounds_[strip.first + i];
      bound = std::max(bound, largest_eigenvalue_bound(blocks, i));
    }
  });
}

template class EffectStiffness<float>;
template class EffectStiffness<double>;

}  // namespace hooke
