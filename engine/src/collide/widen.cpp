#include "collide/widen.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collide/widen.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Two vectors at a time: a comparison takes several cycles, and the next one waits for it.
template <class Real>
HWY_INLINE void widen_range(Real& lowest, Real& highest, const Real* before, const Real* after,
                            std::size_t begin, std::size_t end) {
  const hn::ScalableTag<Real> d;
  using V = hn::Vec<decltype(d)>;
  const std::size_t lanes = hn::Lanes(d);
  V low = hn::Set(d, lowest), high = hn::Set(d, highest), low2 = low, high2 = high;
  const auto value = [&](std::size_t i) HWY_ATTR {
    const V now = hn::LoadU(d, after + i);
    return before == nullptr ? now : hn::Sub(now, hn::LoadU(d, before + i));
  };
  std::size_t i = begin;
  for (; i + 2 * lanes <= end; i += 2 * lanes) {
    const V a = value(i), b = value(i + lanes);
    low = hn::IfThenElse(hn::Lt(a, low), a, low);
    high = hn::IfThenElse(hn::Gt(a, high), a, high);
    low2 = hn::IfThenElse(hn::Lt(b, low2), b, low2);
    high2 = hn::IfThenElse(hn::Gt(b, high2), b, high2);
  }
  lowest = hn::GetLane(hn::MinOfLanes(d, hn::Min(low, low2)));
  highest = hn::GetLane(hn::MaxOfLanes(d, hn::Max(high, high2)));
  for (; i < end; ++i) {
    const Real last = before == nullptr ? after[i] : after[i] - before[i];
    lowest = std::min(lowest, last);
    highest = std::max(highest, last);
  }
}

}  // namespace

void widen_float(float& low, float& high, const float* before, const float* after, std::size_t begin,
                 std::size_t end) {
  widen_range(low, high, before, after, begin, end);
}

void widen_double(double& low, double& high, const double* before, const double* after, std::size_t begin,
                  std::size_t end) {
  widen_range(low, high, before, after, begin, end);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {

HWY_EXPORT(widen_float);
HWY_EXPORT(widen_double);

void widen(float& low, float& high, const float* before, const float* after, std::size_t begin,
           std::size_t end) {
  HWY_DYNAMIC_DISPATCH(widen_float)(low, high, before, after, begin, end);
}

void widen(double& low, double& high, const double* before, const double* after, std::size_t begin,
           std::size_t end) {
  HWY_DYNAMIC_DISPATCH(widen_double)(low, high, before, after, begin, end);
}

}  // namespace hooke
#endif
