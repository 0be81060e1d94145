// Included once for each instruction set, after hwy/foreach_target.h.

#if defined(HOOKE_ADVANCE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HOOKE_ADVANCE_INL
#undef HOOKE_ADVANCE_INL
#else
#define HOOKE_ADVANCE_INL
#endif

#include <hwy/highway.h>

#include "kernels/packed-inl.h"
#include "methods/next_strip.h"
#include "model/row_store.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// One coordinate of some lanes: position and velocity.
template <class V>
struct Coordinate {
  V x, v;
};

/// A pinned particle is not accelerated whatever the force, also where that is not finite.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V acceleration(D d, const hn::TFromD<D>* force, V inverse_mass) {
  return hn::IfThenElseZero(hn::Gt(inverse_mass, hn::Zero(d)), hn::Mul(hn::Load(d, force), inverse_mass));
}

/// Calls advance(d, lane, inverse mass) for each vector of a strip's lanes, which returns the next x, y and z
/// as an array of Coordinates, and writes them. Returns whether all new values are finite.
template <class Real, class Advance>
HWY_INLINE bool write_next(const Strip<Real>& strip, const BlockRows<Real>& inverse_mass,
                           const NextStrip<Real>& next, const Advance& advance) {
  const hn::CappedTag<Real, block_size> d;
  const auto zero = hn::Zero(d);
  auto zero_if_finite = zero;
  for (std::size_t lane = 0; lane < strip.lanes; lane += hn::Lanes(d)) {
    const auto w = hn::Load(d, inverse_mass.block((strip.first + lane) / block_size) + lane % block_size);
    const auto [x, y, z] = advance(d, lane, w);
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

/// The three coordinates of some lanes.
template <class V>
struct Coordinates {
  Coordinate<V> x, y, z;
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#endif
