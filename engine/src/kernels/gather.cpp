#include "kernels/gather.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/gather.cpp"
#include <hwy/foreach_target.h>

#include "kernels/slot_reader-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

/// The forces on vectors of particles, as for_each_spring() takes them.
template <std::size_t vectors, class Reader, class List, class V = typename Reader::V>
HWY_INLINE void gather(const Reader& reader, const List& list, std::size_t first, std::size_t lane,
                       Vector3<V>* HWY_RESTRICT sums) {
  const typename Reader::D d;
  Vector3<V> sum[vectors];
  for (std::size_t v = 0; v < vectors; ++v) sum[v] = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  const auto add = [&](std::size_t v, const auto& own, const auto& other, const auto& rows) HWY_ATTR {
    const auto force = Reader::force_on_other(own, other, rows);
    sum[v] = {hn::NegMulAdd(force.factor, force.apart.x, sum[v].x),
              hn::NegMulAdd(force.factor, force.apart.y, sum[v].y),
              hn::NegMulAdd(force.factor, force.apart.z, sum[v].z)};
  };
  for_each_spring<vectors>(reader, list, first, lane, add);
  for (std::size_t v = 0; v < vectors; ++v) sums[v] = sum[v];
}

template <class Real>
void gather_blocks(const Slots<Real>& slots, const State<Real>& state, std::size_t begin, std::size_t end,
                   StripForce<Real>& force) {
  with_reader(slots, state, [&](const auto& reader) HWY_ATTR {
    using Reader = std::remove_cvref_t<decltype(reader)>;
    const typename Reader::D d;
    const auto gather_list = [&]<std::size_t vectors>(const auto& list, std::size_t first, std::size_t lane)
                                 HWY_ATTR {
                                   Vector3<typename Reader::V> sums[vectors];
                                   gather<vectors>(reader, list, first, lane, sums);
                                   for (std::size_t v = 0; v < vectors; ++v) {
                                     const std::size_t out = first - begin * block_size + v * block_size;
                                     hn::Store(sums[v].x, d, force.x + out);
                                     hn::Store(sums[v].y, d, force.y + out);
                                     hn::Store(sums[v].z, d, force.z + out);
                                   }
                                 };
    for_each_vector_of_blocks(slots, begin, end, gather_list);
  });
}

}  // namespace

void gather_float(const Slots<float>& slots, const State<float>& state, std::size_t begin, std::size_t end,
                  StripForce<float>& force) {
  gather_blocks(slots, state, begin, end, force);
}

void gather_double(const Slots<double>& slots, const State<double>& state, std::size_t begin, std::size_t end,
                   StripForce<double>& force) {
  gather_blocks(slots, state, begin, end, force);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <cmath>

#include "model/slot_springs.h"

namespace hooke {
namespace {

HWY_EXPORT(gather_float);
HWY_EXPORT(gather_double);

}  // namespace

template <>
void gather_springs(const Slots<float>& slots, const State<float>& state, std::size_t begin, std::size_t end,
                    StripForce<float>& force) {
  HWY_DYNAMIC_DISPATCH(gather_float)(slots, state, begin, end, force);
}

template <>
void gather_springs(const Slots<double>& slots, const State<double>& state, std::size_t begin,
                    std::size_t end, StripForce<double>& force) {
  HWY_DYNAMIC_DISPATCH(gather_double)(slots, state, begin, end, force);
}

template <class Real>
SpringMeasure measure_gathered(const Slots<Real>& slots, const State<Real>& state, std::size_t block) {
  SpringMeasure measure;
  for_each_spring(slots, state.size(), block,
                  [&](std::size_t own, std::size_t other, const SlotSpring& spring) {
                    if (spring.stiffness == 0.0) return;
                    const double length = std::hypot(double(state.x()[other]) - double(state.x()[own]),
                                                     double(state.y()[other]) - double(state.y()[own]),
                                                     double(state.z()[other]) - double(state.z()[own]));
                    measure.add_spring(length, spring.stiffness, spring.pull);
                  });
  measure.energy /= double(slots.ends);
  return measure;
}

template SpringMeasure measure_gathered(const Slots<float>&, const State<float>&, std::size_t);
template SpringMeasure measure_gathered(const Slots<double>&, const State<double>&, std::size_t);

}  // namespace hooke
#endif
