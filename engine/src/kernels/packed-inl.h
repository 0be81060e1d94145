// Included once for each instruction set, after hwy/foreach_target.h.

#if defined(HOOKE_PACKED_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HOOKE_PACKED_INL
#undef HOOKE_PACKED_INL
#else
#define HOOKE_PACKED_INL
#endif

#include <hwy/highway.h>

#include "kernels/spring-inl.h"
#include "model/slots.h"
#include "state.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

template <class Value, class Offset>
HWY_INLINE Value* at_offset(Value* packed, Offset offset) {
  constexpr std::ptrdiff_t unit = std::ptrdiff_t(offset_bytes / sizeof(Value));
  return packed + std::ptrdiff_t(offset) * unit;
}

/// A packed vector: three coordinates, and what is behind them.
template <class V>
struct Vector4 {
  Vector3<V> xyz;
  V w;
};

#if HWY_TARGET == HWY_SCALAR

template <class D, class Offset, class V = hn::Vec<D>, class Real = hn::TFromD<D>>
HWY_INLINE Vector4<V> load_packed4(D d, const Real* packed, const Offset* offsets) {
  const Real* const p = at_offset(packed, offsets[0]);
  return {{hn::Set(d, p[0]), hn::Set(d, p[1]), hn::Set(d, p[2])}, hn::Set(d, p[3])};
}

template <class D, class V = hn::Vec<D>, class Real = hn::TFromD<D>>
HWY_INLINE void store_packed(D d, V x, V y, V z, Real* packed) {
  hn::Store(x, d, packed);
  hn::Store(y, d, packed + 1);
  hn::Store(z, d, packed + 2);
}

#else

/// A vector of 128-bit blocks, each loaded from its own place: block b from offsets[b * stride] behind
/// packed. Three plain loads for each particle and a transpose in registers are faster than hardware gathers,
/// which load every coordinate on its own.
template <class D, class Offset, class Real = hn::TFromD<D>>
HWY_INLINE hn::Vec<D> load_blocks(D d, const Real* packed, const Offset* offsets, std::size_t stride) {
  constexpr std::size_t in_block = 16 / sizeof(Real);
  if constexpr (hn::MaxLanes(D()) <= in_block) {
    return hn::LoadU(d, at_offset(packed, offsets[0]));
  } else {
    const hn::Half<D> half;
    constexpr std::size_t blocks_in_half = hn::MaxLanes(hn::Half<D>()) / in_block;
    return hn::Combine(d, load_blocks(half, packed, offsets + blocks_in_half * stride, stride),
                       load_blocks(half, packed, offsets, stride));
  }
}

/// The vectors that begin offsets[lane] behind packed, in units of offset_bytes.
template <class D, class Offset, class V = hn::Vec<D>>
HWY_INLINE Vector4<V> load_packed4(D d, const hn::TFromD<D>* packed, const Offset* offsets) {
  using Real = hn::TFromD<D>;
  if constexpr (sizeof(Real) == sizeof(double)) {
    // A block holds x, y or z, w.
    const V xy0 = load_blocks(d, packed, offsets, 2), xy1 = load_blocks(d, packed, offsets + 1, 2);
    const V z0 = load_blocks(d, packed + 2, offsets, 2), z1 = load_blocks(d, packed + 2, offsets + 1, 2);
    return {
        {hn::InterleaveLower(d, xy0, xy1), hn::InterleaveUpper(d, xy0, xy1), hn::InterleaveLower(d, z0, z1)},
        hn::InterleaveUpper(d, z0, z1)};
  } else {
    // A block holds x, y, z, w: four of them are transposed in three steps.
    const V a0 = load_blocks(d, packed, offsets, 4), a1 = load_blocks(d, packed, offsets + 1, 4);
    const V a2 = load_blocks(d, packed, offsets + 2, 4), a3 = load_blocks(d, packed, offsets + 3, 4);
    const hn::Repartition<double, D> pairs;
    const auto xy01 = hn::BitCast(pairs, hn::InterleaveLower(d, a0, a1));
    const auto xy23 = hn::BitCast(pairs, hn::InterleaveLower(d, a2, a3));
    const auto z01 = hn::BitCast(pairs, hn::InterleaveUpper(d, a0, a1));
    const auto z23 = hn::BitCast(pairs, hn::InterleaveUpper(d, a2, a3));
    return {{hn::BitCast(d, hn::InterleaveLower(pairs, xy01, xy23)),
             hn::BitCast(d, hn::InterleaveUpper(pairs, xy01, xy23)),
             hn::BitCast(d, hn::InterleaveLower(pairs, z01, z23))},
            hn::BitCast(d, hn::InterleaveUpper(pairs, z01, z23))};
  }
}

/// Writes the vectors of as many particles as there are lanes.
template <class D, class V = hn::Vec<D>, class Real = hn::TFromD<D>>
HWY_INLINE void store_packed(D d, V x, V y, V z, Real* packed) {
  hn::StoreInterleaved4(x, y, z, hn::Zero(d), d, packed);
}

#endif

/// x, y and z of them.
template <class D, class Offset, class V = hn::Vec<D>>
HWY_INLINE Vector3<V> load_packed(D d, const hn::TFromD<D>* packed, const Offset* offsets) {
  return load_packed4(d, packed, offsets).xyz;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#endif
