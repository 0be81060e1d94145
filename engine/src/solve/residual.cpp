#include "solve/residual.h"

#include "kernels/flush_subnormals.h"
#include "parallel/sum.h"
#include "solve/lane_sums.h"

namespace hooke {
namespace {

/// One coordinate on a strip.
template <class Real>
void residual_of_lanes(const Strip<Real>& strip, const BlockRows<Real>& mass,
                       const BlockRows<Real>& inverse_mass, Real h, const Real* from_v, const Real* v,
                       const Real* force, Real* out) {
  for (std::size_t lane = 0; lane < strip.lanes; lane += block_size) {
    const std::size_t block = (strip.first + lane) / block_size;
    const Real* const m = mass.block(block);
    const Real* const w = inverse_mass.block(block);
    for (std::size_t i = 0; i < block_size; ++i) {
      const Real value = m[i] * (from_v[lane + i] - v[lane + i]) + h * force[lane + i];
      out[lane + i] = w[i] > Real(0) ? value : Real(0);
    }
  }
}

}  // namespace

template <class Real>
Residual<Real>::Residual(const SolverContext<Real>& context)
    : model_(context.model),
      forces_(context.forces),
      executor_(context.executor),
      mass_(context.model.particles(),
            [&](std::size_t i) {
              return context.model.pinned(i) ? Real(0) : Real(1) / context.model.inverse_mass[i];
            }),
      values_(context.model.particles()) {}

template <class Real>
double Residual<Real>::evaluate(const ImplicitStage<Real>& stage, const State<Real>& at,
                                const ParticleVectors<Real>& direction) {
  if (model_.islands_changed(islands_seen_)) values_.set_zero();
  forces_.prepare(at, stage.time, executor_);
  const auto part = [&](std::size_t begin, std::size_t end) {
    const FlushSubnormals flush;
    LaneSums sums;
    StripForce<Real> force;
    model_.for_each_awake_strip(begin, end, [&](std::size_t first, std::size_t last) {
      const Strip<Real> strip(at, first, last), from(stage.from, first, last);
      forces_.on_strip(strip, at, stage.time, force);
      const std::size_t place = strip.first;
      const Real h = Real(stage.h);
      residual_of_lanes(strip, mass_, model_.inverse_mass, h, from.vx, strip.vx, force.x,
                        values_.x() + place);
      residual_of_lanes(strip, mass_, model_.inverse_mass, h, from.vy, strip.vy, force.y,
                        values_.y() + place);
      residual_of_lanes(strip, mass_, model_.inverse_mass, h, from.vz, strip.vz, force.z,
                        values_.z() + place);
      sums.add_dot(values_, direction, place, strip.lanes);
    });
    return DotSum{sums.total()};
  };
  return sum_in_order<DotSum>(executor_, block_count(at.size()), solved_blocks, part, sums_).value;
}

template class Residual<float>;
template class Residual<double>;

}  // namespace hooke
