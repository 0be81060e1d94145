#include "methods/runge_kutta.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/runge_kutta.cpp"
#include <hwy/foreach_target.h>

#include "methods/advance-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

template <class Real>
HWY_INLINE bool advance_strip(const NystromStage<Real>& stage, const Strip<Real>& start,
                              const StripForce<Real>& force, const BlockRows<Real>& inverse_mass,
                              const NextStrip<Real>& next) {
  const hn::CappedTag<Real, block_size> tag;
  using V = hn::Vec<decltype(tag)>;
  const V drift = hn::Set(tag, stage.drift), for_position = hn::Set(tag, stage.position),
          for_velocity = hn::Set(tag, stage.velocity);
  return write_next(start, inverse_mass, next, [&](auto d, std::size_t lane, V inverse) HWY_ATTR {
    const auto coordinate = [&](const Real* x, const Real* v, const Real* f,
                                const Real* WeightedAccelerations<Real>::*axis, Real* keep) HWY_ATTR {
      const V a = acceleration(d, f + lane, inverse), velocity = hn::LoadU(d, v + lane);
      if (keep != nullptr) hn::Store(a, d, keep + lane);
      Coordinate<V> sum{hn::MulAdd(drift, velocity, hn::LoadU(d, x + lane)), velocity};
      for (const WeightedAccelerations<Real>& earlier : stage.earlier) {
        const V b = hn::Load(d, earlier.*axis + lane);
        sum.x = hn::MulAdd(hn::Set(d, earlier.position), b, sum.x);
        sum.v = hn::MulAdd(hn::Set(d, earlier.velocity), b, sum.v);
      }
      return Coordinate<V>{hn::MulAdd(for_position, a, sum.x), hn::MulAdd(for_velocity, a, sum.v)};
    };
    return Coordinates<V>{
        coordinate(start.x, start.vx, force.x, &WeightedAccelerations<Real>::x, stage.keep_x),
        coordinate(start.y, start.vy, force.y, &WeightedAccelerations<Real>::y, stage.keep_y),
        coordinate(start.z, start.vz, force.z, &WeightedAccelerations<Real>::z, stage.keep_z)};
  });
}

}  // namespace

bool advance_stage_float(const NystromStage<float>& stage, const Strip<float>& start,
                         const StripForce<float>& force, const BlockRows<float>& inverse_mass,
                         const NextStrip<float>& next) {
  return advance_strip(stage, start, force, inverse_mass, next);
}

bool advance_stage_double(const NystromStage<double>& stage, const Strip<double>& start,
                          const StripForce<double>& force, const BlockRows<double>& inverse_mass,
                          const NextStrip<double>& next) {
  return advance_strip(stage, start, force, inverse_mass, next);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <array>

namespace hooke {
namespace {

HWY_EXPORT(advance_stage_float);
HWY_EXPORT(advance_stage_double);

/// The most stages of a method here: Dormand and Prince's.
constexpr std::size_t most_stages = 6;

}  // namespace

bool advance_stage(const NystromStage<float>& stage, const Strip<float>& start,
                   const StripForce<float>& force, const BlockRows<float>& inverse_mass,
                   const NextStrip<float>& next) {
  return HWY_DYNAMIC_DISPATCH(advance_stage_float)(stage, start, force, inverse_mass, next);
}

bool advance_stage(const NystromStage<double>& stage, const Strip<double>& start,
                   const StripForce<double>& force, const BlockRows<double>& inverse_mass,
                   const NextStrip<double>& next) {
  return HWY_DYNAMIC_DISPATCH(advance_stage_double)(stage, start, force, inverse_mass, next);
}

template <class Real>
bool RungeKutta<Real>::advance(std::size_t stage, double h, const Strip<Real>& start,
                               const StripForce<Real>& force, const BlockRows<Real>& inverse_mass,
                               const NextStrip<Real>& next) {
  const NystromRow& row = rows_[stage];
  const bool is_known = known(stage), keeps = stage < kept_ && !is_known;
  std::array<WeightedAccelerations<Real>, most_stages> earlier;
  std::size_t count = 0;
  for (std::size_t j = 0; j < stage + is_known; ++j) {
    if (row.position[j] == 0.0 && row.velocity[j] == 0.0) continue;
    earlier[count++] = {accelerations_.x(j) + start.first, accelerations_.y(j) + start.first,
                        accelerations_.z(j) + start.first, Real(row.position[j] * h * h),
                        Real(row.velocity[j] * h)};
  }
  NystromStage<Real> weights{Real(row.time * h), 0, 0, std::span(earlier.data(), count), {}, {}, {}};
  if (!is_known) {
    weights.position = Real(row.position[stage] * h * h);
    weights.velocity = Real(row.velocity[stage] * h);
  }
  if (keeps) {
    weights.keep_x = accelerations_.x(stage) + start.first;
    weights.keep_y = accelerations_.y(stage) + start.first;
    weights.keep_z = accelerations_.z(stage) + start.first;
  }
  return advance_stage(weights, start, force, inverse_mass, next);
}

template class RungeKutta<float>;
template class RungeKutta<double>;

}  // namespace hooke
#endif
