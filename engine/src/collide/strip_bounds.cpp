#include "collide/strip_bounds.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collide/strip_bounds.cpp"
#include <hwy/foreach_target.h>

#include "effects/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

template <class Real>
HWY_INLINE void bound_axis(const Real* a, const Real* b, std::size_t count, Real& low, Real& high) {
  const LaneTag<Real> d;
  auto least = hn::Min(hn::Load(d, a), hn::Load(d, b)), most = hn::Max(hn::Load(d, a), hn::Load(d, b));
  for (std::size_t i = hn::Lanes(d); i < count; i += hn::Lanes(d)) {
    const auto first = hn::Load(d, a + i), second = hn::Load(d, b + i);
    least = hn::Min(least, hn::Min(first, second));
    most = hn::Max(most, hn::Max(first, second));
  }
  low = hn::GetLane(hn::MinOfLanes(d, least));
  high = hn::GetLane(hn::MaxOfLanes(d, most));
}

template <class Real>
HWY_INLINE Bounds<Real> bound(const State<Real>& a, const State<Real>& b, std::size_t begin,
                              std::size_t end) {
  Bounds<Real> bounds;
  const std::size_t first = begin * block_size, count = (end - begin) * block_size;
  bound_axis(a.x() + first, b.x() + first, count, bounds.low[0], bounds.high[0]);
  bound_axis(a.y() + first, b.y() + first, count, bounds.low[1], bounds.high[1]);
  bound_axis(a.z() + first, b.z() + first, count, bounds.low[2], bounds.high[2]);
  return bounds;
}

template <class Real>
HWY_INLINE std::size_t meeting(const BoundsList<Real>& list, const Bounds<Real>& box, std::size_t from) {
  const Bounds<Real>& all = list.all();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (box.low[axis] > all.high[axis] || box.high[axis] < all.low[axis]) return list.size();
  }
  const LaneTag<Real> d;
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t i = from / lanes * lanes; i < list.size(); i += lanes) {
    auto meets = hn::Le(hn::Load(d, list.low(0) + i), hn::Set(d, box.high[0]));
    meets = hn::And(meets, hn::Ge(hn::Load(d, list.high(0) + i), hn::Set(d, box.low[0])));
    for (std::size_t axis = 1; axis < 3; ++axis) {
      meets = hn::And(meets, hn::Le(hn::Load(d, list.low(axis) + i), hn::Set(d, box.high[axis])));
      meets = hn::And(meets, hn::Ge(hn::Load(d, list.high(axis) + i), hn::Set(d, box.low[axis])));
    }
    std::uint32_t bits = bits_of(d, meets);
    if (i < from) bits &= ~0u << (from - i);
    if (bits != 0) return i + std::size_t(std::countr_zero(bits));
  }
  return list.size();
}

}  // namespace

Bounds<float> bound_float(const State<float>& a, const State<float>& b, std::size_t begin, std::size_t end) {
  return bound(a, b, begin, end);
}
Bounds<double> bound_double(const State<double>& a, const State<double>& b, std::size_t begin,
                            std::size_t end) {
  return bound(a, b, begin, end);
}
std::size_t meeting_float(const BoundsList<float>& list, const Bounds<float>& box, std::size_t from) {
  return meeting(list, box, from);
}
std::size_t meeting_double(const BoundsList<double>& list, const Bounds<double>& box, std::size_t from) {
  return meeting(list, box, from);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {

HWY_EXPORT(bound_float);
HWY_EXPORT(bound_double);
HWY_EXPORT(meeting_float);
HWY_EXPORT(meeting_double);

Bounds<float> bounds_of(const State<float>& a, const State<float>& b, std::size_t begin, std::size_t end) {
  return HWY_DYNAMIC_DISPATCH(bound_float)(a, b, begin, end);
}

Bounds<double> bounds_of(const State<double>& a, const State<double>& b, std::size_t begin, std::size_t end) {
  return HWY_DYNAMIC_DISPATCH(bound_double)(a, b, begin, end);
}

template <class Real>
void BoundsList<Real>::drop(std::size_t box) {
  values_[0][box] = infinite;
  values_[3][box] = -infinite;
}

template <class Real>
void BoundsList<Real>::widen(std::size_t box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    values_[axis][box] = all_.low[axis] = -infinite;
    values_[3 + axis][box] = all_.high[axis] = infinite;
  }
}

template <class Real>
void BoundsList<Real>::add(const Bounds<Real>& bounds) {
  ++size_;
  const std::size_t padded = (size_ + block_size - 1) / block_size * block_size;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    values_[axis].resize(padded, infinite);
    values_[3 + axis].resize(padded, -infinite);
    values_[axis][size_ - 1] = bounds.low[axis];
    values_[3 + axis][size_ - 1] = bounds.high[axis];
    all_.low[axis] = std::min(all_.low[axis], bounds.low[axis]);
    all_.high[axis] = std::max(all_.high[axis], bounds.high[axis]);
  }
}

template <class Real>
std::size_t BoundsList<Real>::bytes() const {
  std::size_t bytes = 0;
  for (const auto& values : values_) bytes += values.capacity() * sizeof(Real);
  return bytes;
}

template class BoundsList<float>;
template class BoundsList<double>;

std::size_t next_meeting(const BoundsList<float>& list, const Bounds<float>& box, std::size_t from) {
  return HWY_DYNAMIC_DISPATCH(meeting_float)(list, box, from);
}

std::size_t next_meeting(const BoundsList<double>& list, const Bounds<double>& box, std::size_t from) {
  return HWY_DYNAMIC_DISPATCH(meeting_double)(list, box, from);
}

}  // namespace hooke
#endif
