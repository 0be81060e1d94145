#include "methods/euler.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/euler.cpp"
#include <hwy/foreach_target.h>

#include "kernels/packed-inl.h"

#ifndef HOOKE_EULER_STRIP
#define HOOKE_EULER_STRIP
namespace hooke {

/// Which velocity moves the particles: the new one (symplectic) or the old one (explicit).
enum class MoveWith { new_velocity, old_velocity };

/// Where the next state of a strip goes; packed copies where the state has them, else null.
template <class Real>
struct NextStrip {
  Real *x, *y, *z, *vx, *vy, *vz;
  Real *packed_positions, *packed_velocities;

  NextStrip(State<Real>& state, std::size_t first)
      : x(state.x() + first),
        y(state.y() + first),
        z(state.z() + first),
        vx(state.vx() + first),
        vy(state.vy() + first),
        vz(state.vz() + first),
        packed_positions(at(state.packed_positions(), first)),
        packed_velocities(at(state.packed_velocities(), first)) {}

 private:
  static Real* at(Real* packed, std::size_t first) {
    return packed == nullptr ? nullptr : packed + first * packed_width;
  }
};

}  // namespace hooke
#endif

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// One coordinate of some lanes: position and velocity, and then the next ones.
template <class V>
struct Coordinate {
  V x, v;
};

template <MoveWith move_with, class D, class V = hn::Vec<D>, class Real = hn::TFromD<D>>
HWY_INLINE Coordinate<V> advance(D d, const Real* x, const Real* v, const Real* force, V inverse_mass, V h) {
  const V old_v = hn::LoadU(d, v);
  // A pinned particle keeps its velocity whatever the force, also where that is not finite.
  const V acceleration =
      hn::IfThenElseZero(hn::Gt(inverse_mass, hn::Zero(d)), hn::Mul(hn::Load(d, force), inverse_mass));
  const V new_v = hn::MulAdd(h, acceleration, old_v);
  const V mover = move_with == MoveWith::new_velocity ? new_v : old_v;
  return {hn::MulAdd(h, mover, hn::LoadU(d, x)), new_v};
}

/// Returns whether all new values are finite.
template <MoveWith move_with, class Real>
HWY_INLINE bool advance_strip(const Strip<Real>& now, const StripForce<Real>& force,
                              const BlockRows<Real>& inverse_mass, Real step, const NextStrip<Real>& next) {
  const hn::CappedTag<Real, block_size> d;
  const auto h = hn::Set(d, step), zero = hn::Zero(d);
  auto zero_if_finite = zero;
  for (std::size_t lane = 0; lane < now.lanes; lane += hn::Lanes(d)) {
    const auto w = hn::Load(d, inverse_mass.block((now.first + lane) / block_size) + lane % block_size);
    const auto x = advance<move_with>(d, now.x + lane, now.vx + lane, force.x + lane, w, h);
    const auto y = advance<move_with>(d, now.y + lane, now.vy + lane, force.y + lane, w, h);
    const auto z = advance<move_with>(d, now.z + lane, now.vz + lane, force.z + lane, w, h);
    hn::StoreU(x.x, d, next.x + lane);
    hn::StoreU(y.x, d, next.y + lane);
    hn::StoreU(z.x, d, next.z + lane);
    hn::StoreU(x.v, d, next.vx + lane);
    hn::StoreU(y.v, d, next.vy + lane);
    hn::StoreU(z.v, d, next.vz + lane);
    if (next.packed_positions != nullptr)
      store_packed(d, x.x, y.x, z.x, next.packed_positions + lane * packed_width);
    if (next.packed_velocities != nullptr)
      store_packed(d, x.v, y.v, z.v, next.packed_velocities + lane * packed_width);
    // Zero times a value that is not finite is not a number, and stays so in the sum.
    for (const auto& value : {x.x, y.x, z.x, x.v, y.v, z.v})
      zero_if_finite = hn::MulAdd(zero, value, zero_if_finite);
  }
  return hn::AllTrue(d, hn::Eq(zero_if_finite, zero));
}

template <class Real>
HWY_INLINE bool advance_strip(MoveWith move_with, const Strip<Real>& now, const StripForce<Real>& force,
                              const BlockRows<Real>& inverse_mass, Real h, const NextStrip<Real>& next) {
  return move_with == MoveWith::new_velocity
             ? advance_strip<MoveWith::new_velocity>(now, force, inverse_mass, h, next)
             : advance_strip<MoveWith::old_velocity>(now, force, inverse_mass, h, next);
}

}  // namespace

bool advance_float(MoveWith move_with, const Strip<float>& now, const StripForce<float>& force,
                   const BlockRows<float>& inverse_mass, float h, const NextStrip<float>& next) {
  return advance_strip(move_with, now, force, inverse_mass, h, next);
}

bool advance_double(MoveWith move_with, const Strip<double>& now, const StripForce<double>& force,
                    const BlockRows<double>& inverse_mass, double h, const NextStrip<double>& next) {
  return advance_strip(move_with, now, force, inverse_mass, h, next);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <cmath>

#include "kernels/flush_subnormals.h"

namespace hooke {
namespace {

HWY_EXPORT(advance_float);
HWY_EXPORT(advance_double);

bool advance(MoveWith move_with, const Strip<float>& now, const StripForce<float>& force,
             const BlockRows<float>& inverse_mass, float h, const NextStrip<float>& next) {
  return HWY_DYNAMIC_DISPATCH(advance_float)(move_with, now, force, inverse_mass, h, next);
}

bool advance(MoveWith move_with, const Strip<double>& now, const StripForce<double>& force,
             const BlockRows<double>& inverse_mass, double h, const NextStrip<double>& next) {
  return HWY_DYNAMIC_DISPATCH(advance_double)(move_with, now, force, inverse_mass, h, next);
}

template <class Real>
void note_first_bad(const NextStrip<Real>& next, const Strip<Real>& strip, const Order& order,
                    std::atomic<Index>& first_bad) {
  for (std::size_t lane = 0; lane < strip.particles; ++lane) {
    const Real values[] = {next.x[lane],  next.y[lane],  next.z[lane],
                           next.vx[lane], next.vy[lane], next.vz[lane]};
    bool finite = true;
    for (Real value : values) finite = finite && std::isfinite(value);
    if (finite) continue;
    const Index particle = order.user(strip.first + lane);
    Index lowest = first_bad.load();
    while (particle < lowest && !first_bad.compare_exchange_weak(lowest, particle)) {
    }
  }
}

template <class Real>
void advance_blocks(MoveWith move_with, const Model<Real>& model, Forces<Real>& forces,
                    const Step<Real>& step, std::size_t begin, std::size_t end) {
  const FlushSubnormals flush;
  StripForce<Real> force;
  for_each_strip(begin, end, [&](std::size_t first, std::size_t last) {
    const Strip<Real> strip(step.now, first, last);
    forces.on_strip(strip, step.now, step.time, force);
    const NextStrip<Real> after(step.next, strip.first);
    if (!advance(move_with, strip, force, model.inverse_mass, Real(step.h), after))
      note_first_bad(after, strip, model.order, step.first_bad);
  });
}

}  // namespace

template <class Real>
void euler_blocks(const SymplecticEuler&, const Model<Real>& model, Forces<Real>& forces,
                  const Step<Real>& step, std::size_t begin, std::size_t end) {
  advance_blocks(MoveWith::new_velocity, model, forces, step, begin, end);
}

template <class Real>
void euler_blocks(const ExplicitEuler&, const Model<Real>& model, Forces<Real>& forces,
                  const Step<Real>& step, std::size_t begin, std::size_t end) {
  advance_blocks(MoveWith::old_velocity, model, forces, step, begin, end);
}

#define HOOKE_EULER(METHOD, REAL)                                                                 \
  template void euler_blocks(const METHOD&, const Model<REAL>&, Forces<REAL>&, const Step<REAL>&, \
                             std::size_t, std::size_t);
HOOKE_EULER(SymplecticEuler, float)
HOOKE_EULER(SymplecticEuler, double)
HOOKE_EULER(ExplicitEuler, float)
HOOKE_EULER(ExplicitEuler, double)
#undef HOOKE_EULER

}  // namespace hooke
#endif
