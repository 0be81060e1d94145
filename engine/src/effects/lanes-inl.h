// Included once for each instruction set, after hwy/foreach_target.h.

#if defined(HOOKE_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HOOKE_LANES_INL
#undef HOOKE_LANES_INL
#else
#define HOOKE_LANES_INL
#endif

#include <cstdint>

#include <hwy/highway.h>

#include "strip.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

template <class Real>
using LaneTag = hn::CappedTag<Real, block_size>;

/// Calls visit(d, lane) for each vector of a strip's lanes.
template <class Real, class Visit>
HWY_INLINE void for_each_vector(const Strip<Real>& strip, const Visit& visit) {
  const LaneTag<Real> d;
  for (std::size_t lane = 0; lane < strip.lanes; lane += hn::Lanes(d)) visit(d, lane);
}

/// Of up to 16 lanes a bit each.
template <class D>
HWY_INLINE std::uint32_t bits_of(D d, hn::Mask<D> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  return std::uint32_t(bytes[0]) | std::uint32_t(bytes[1]) << 8;
}

template <class D>
HWY_INLINE hn::Mask<D> mask_of(D d, std::uint32_t bits) {
  const std::uint8_t bytes[8] = {std::uint8_t(bits), std::uint8_t(bits >> 8)};
  return hn::LoadMaskBits(d, bytes);
}

/// sum[lane...] += a b.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void add_product(D d, V a, V b, hn::TFromD<D>* sum) {
  hn::Store(hn::MulAdd(a, b, hn::Load(d, sum)), d, sum);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#endif
