#include "methods/splitting.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/splitting.cpp"
#include <hwy/foreach_target.h>

#include "methods/advance-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

template <bool has_pending_kick, class Real>
HWY_INLINE bool kick_and_drift_strip(const KickDrift& stage, const Strip<Real>& now,
                                     const StripForce<Real>& force, const BlockRows<Real>& inverse_mass,
                                     const NextStrip<Real>& next) {
  const hn::CappedTag<Real, block_size> tag;
  using V = hn::Vec<decltype(tag)>;
  const V pending = hn::Set(tag, Real(stage.pending_kick)), kick = hn::Set(tag, Real(stage.kick));
  const V drift = hn::Set(tag, Real(stage.drift));
  return write_next(now, inverse_mass, next, [&](auto d, std::size_t lane, V inverse) HWY_ATTR {
    const auto coordinate = [&](const Real* x, const Real* v, const Real* f) HWY_ATTR {
      const V a = acceleration(d, f + lane, inverse);
      V velocity = hn::LoadU(d, v + lane);
      // Two roundings, as in a run that is read between its steps.
      if constexpr (has_pending_kick) velocity = hn::MulAdd(pending, a, velocity);
      velocity = hn::MulAdd(kick, a, velocity);
      return Coordinate<V>{hn::MulAdd(drift, velocity, hn::LoadU(d, x + lane)), velocity};
    };
    return Coordinates<V>{coordinate(now.x, now.vx, force.x), coordinate(now.y, now.vy, force.y),
                          coordinate(now.z, now.vz, force.z)};
  });
}

template <class Real>
HWY_INLINE bool kick_and_drift_any(const KickDrift& stage, const Strip<Real>& now,
                                   const StripForce<Real>& force, const BlockRows<Real>& inverse_mass,
                                   const NextStrip<Real>& next) {
  return stage.pending_kick == 0.0 ? kick_and_drift_strip<false>(stage, now, force, inverse_mass, next)
                                   : kick_and_drift_strip<true>(stage, now, force, inverse_mass, next);
}

}  // namespace

bool kick_and_drift_float(const KickDrift& stage, const Strip<float>& now, const StripForce<float>& force,
                          const BlockRows<float>& inverse_mass, const NextStrip<float>& next) {
  return kick_and_drift_any(stage, now, force, inverse_mass, next);
}

bool kick_and_drift_double(const KickDrift& stage, const Strip<double>& now, const StripForce<double>& force,
                           const BlockRows<double>& inverse_mass, const NextStrip<double>& next) {
  return kick_and_drift_any(stage, now, force, inverse_mass, next);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <numeric>

namespace hooke {
namespace {

HWY_EXPORT(kick_and_drift_float);
HWY_EXPORT(kick_and_drift_double);

}  // namespace

bool kick_and_drift(const KickDrift& stage, const Strip<float>& now, const StripForce<float>& force,
                    const BlockRows<float>& inverse_mass, const NextStrip<float>& next) {
  return HWY_DYNAMIC_DISPATCH(kick_and_drift_float)(stage, now, force, inverse_mass, next);
}

bool kick_and_drift(const KickDrift& stage, const Strip<double>& now, const StripForce<double>& force,
                    const BlockRows<double>& inverse_mass, const NextStrip<double>& next) {
  return HWY_DYNAMIC_DISPATCH(kick_and_drift_double)(stage, now, force, inverse_mass, next);
}

double Splitting::time(std::size_t stage) const {
  return std::accumulate(drifts.begin(), drifts.begin() + std::ptrdiff_t(stage), 0.0);
}

Splitting splitting(const SymplecticEuler&) {
  return {{1.0}, {1.0}, 0.0};
}

Splitting splitting(const Verlet&) {
  return {{0.5}, {1.0}, 0.5};
}

Splitting splitting(const BlanesMoan&) {
  constexpr double b1 = 0.0829844064174052, b2 = 0.396309801498368, b3 = -0.0390563049223486;
  constexpr double a1 = 0.245298957184271, a2 = 0.604872665711080;
  constexpr double b4 = 1.0 - 2.0 * (b1 + b2 + b3), a3 = 0.5 - (a1 + a2);
  return {{b1, b2, b3, b4, b3, b2}, {a1, a2, a3, a3, a2, a1}, b1};
}

}  // namespace hooke
#endif
