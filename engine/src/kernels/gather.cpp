#include "kernels/gather.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/gather.cpp"
#include <hwy/foreach_target.h>

#include "kernels/packed-inl.h"
#include "kernels/spring-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

/// Positions of some lanes of a block and, where springs are damped, their velocities.
template <class V>
struct Particles {
  Vector3<V> position, velocity;
};

/// Gathers the forces on the lanes of one vector in a block.
template <class Real, bool damped, class Offset>
class LaneGather {
 public:
  using D = hn::CappedTag<Real, block_size>;
  using V = hn::Vec<D>;

  LaneGather(const Slots<Real>& slots, const State<Real>& state)
      : slots_(slots.slots.data()),
        values_(slots.values.data()),
        offsets_(offsets_of(slots)),
        x_(state.x()),
        y_(state.y()),
        z_(state.z()),
        vx_(state.vx()),
        vy_(state.vy()),
        vz_(state.vz()),
        packed_positions_(state.packed_positions()),
        packed_velocities_(state.packed_velocities()) {}

  /// Forces on `vectors` vectors of lanes, the first from particle `first` on, each `apart` further on than
  /// the one before; all have the list of slots `list`. The first is at lane `lane` of its block.
  template <std::size_t vectors>
  HWY_INLINE void force(const typename Slots<Real>::List& list, std::size_t first, std::size_t lane,
                        Vector3<V>* HWY_RESTRICT out) const {
    Particles<V> own[vectors];
    Vector3<V> sum[vectors];
    for (std::size_t v = 0; v < vectors; ++v) {
      own[v] = at(std::ptrdiff_t(first + v * block_size));
      sum[v] = {hn::Zero(D()), hn::Zero(D()), hn::Zero(D())};
    }
    for (std::uint32_t s = list.first_shift; s < list.first_indexed; ++s) {
      const auto& slot = slots_[s];
      const SpringRows<V> springs = rows(slot, lane);
      for (std::size_t v = 0; v < vectors; ++v)
        sum[v] = add(own[v], at(std::ptrdiff_t(first + v * block_size) + slot.shift), springs, sum[v]);
    }
    if constexpr (vectors == 1) {
      for (std::uint32_t s = list.first_indexed; s < list.end; ++s) {
        const auto& slot = slots_[s];
        const Offset* offsets = offsets_ + std::size_t(slot.neighbours) * block_size + lane;
        sum[0] = add(own[0], at(first - lane, offsets), rows(slot, lane), sum[0]);
      }
    }
    for (std::size_t v = 0; v < vectors; ++v) out[v] = sum[v];
  }

 private:
  static const Offset* offsets_of(const Slots<Real>& slots) {
    if constexpr (sizeof(Offset) == sizeof(std::int16_t))
      return slots.short_offsets.data();
    else
      return slots.long_offsets.data();
  }

  HWY_INLINE Particles<V> at(std::ptrdiff_t i) const {
    Particles<V> particles;
    particles.position = load3(D(), x_ + i, y_ + i, z_ + i);
    if constexpr (damped) particles.velocity = load3(D(), vx_ + i, vy_ + i, vz_ + i);
    return particles;
  }

  /// The neighbours of a block's lanes; `block` is its first particle.
  HWY_INLINE Particles<V> at(std::size_t block, const Offset* offsets) const {
    const std::size_t base = block * packed_width;
    Particles<V> particles;
    particles.position = load_packed(D(), packed_positions_ + base, offsets);
    if constexpr (damped) particles.velocity = load_packed(D(), packed_velocities_ + base, offsets);
    return particles;
  }

  HWY_INLINE SpringRows<V> rows(const typename Slots<Real>::Slot& slot, std::size_t lane) const {
    SpringRows<V> rows;
    rows.stiffness = row(slot.stiffness, lane);
    rows.half_pull = row(slot.half_pull, lane);
    if constexpr (damped) rows.quarter_damping = row(slot.quarter_damping, lane);
    return rows;
  }

  HWY_INLINE V row(std::uint32_t number, std::size_t lane) const {
    return hn::Load(D(), values_ + std::size_t(number) * block_size + lane);
  }

  HWY_INLINE static Vector3<V> add(const Particles<V>& own, const Particles<V>& other,
                                   const SpringRows<V>& rows, const Vector3<V>& sum) {
    const Vector3<V> apart = own.position - other.position;
    Vector3<V> velocity;
    if constexpr (damped) velocity = own.velocity - other.velocity;
    const V factor = spring_factor<damped>(D(), apart, velocity, rows);
    return {hn::NegMulAdd(factor, apart.x, sum.x), hn::NegMulAdd(factor, apart.y, sum.y),
            hn::NegMulAdd(factor, apart.z, sum.z)};
  }

  const typename Slots<Real>::Slot* slots_;
  const Real* values_;
  const Offset* offsets_;
  const Real *x_, *y_, *z_, *vx_, *vy_, *vz_;
  const Real *packed_positions_, *packed_velocities_;
};

template <bool damped, class Offset, class Real>
void gather(const Slots<Real>& slots, const State<Real>& state, std::size_t begin, std::size_t end,
            StripForce<Real>& force) {
  const LaneGather<Real, damped, Offset> lanes(slots, state);
  using D = typename LaneGather<Real, damped, Offset>::D;
  const D d;
  const auto* lists = slots.lists.data();
  const std::uint32_t* list_of_block = slots.list_of_block.data();
  using V = typename LaneGather<Real, damped, Offset>::V;
  const auto store = [&](const Vector3<V>& sum, std::size_t out) HWY_ATTR {
    hn::Store(sum.x, d, force.x + out);
    hn::Store(sum.y, d, force.y + out);
    hn::Store(sum.z, d, force.z + out);
  };
  for (std::size_t block = begin; block < end;) {
    const auto& list = lists[list_of_block[block]];
    const std::size_t out = (block - begin) * block_size;
    if (hn::MaxLanes(D()) == block_size && block + 1 < end &&
        list_of_block[block + 1] == list_of_block[block] && list.first_indexed == list.end) {
      Vector3<V> sums[2];
      lanes.template force<2>(list, block * block_size, 0, sums);
      store(sums[0], out);
      store(sums[1], out + block_size);
      block += 2;
      continue;
    }
    for (std::size_t lane = 0; lane < block_size; lane += hn::Lanes(d)) {
      Vector3<V> sum[1];
      lanes.template force<1>(list, block * block_size + lane, lane, sum);
      store(sum[0], out + lane);
    }
    ++block;
  }
}

template <class Real>
void gather_any(const Slots<Real>& slots, const State<Real>& state, std::size_t begin, std::size_t end,
                StripForce<Real>& force) {
  const auto gather_with = [&]<class Offset>(Offset) {
    slots.damped ? gather<true, Offset>(slots, state, begin, end, force)
                 : gather<false, Offset>(slots, state, begin, end, force);
  };
  slots.long_offsets.empty() ? gather_with(std::int16_t{}) : gather_with(std::int32_t{});
}

}  // namespace

void gather_float(const Slots<float>& slots, const State<float>& state, std::size_t begin, std::size_t end,
                  StripForce<float>& force) {
  gather_any(slots, state, begin, end, force);
}

void gather_double(const Slots<double>& slots, const State<double>& state, std::size_t begin, std::size_t end,
                   StripForce<double>& force) {
  gather_any(slots, state, begin, end, force);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <cmath>

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
  const std::size_t first = block * block_size;
  const auto& list = slots.list(block);
  SpringMeasure measure;
  for (std::uint32_t s = list.first_shift; s < list.end; ++s) {
    const auto& slot = slots.slots[s];
    for (std::size_t lane = 0; lane < block_size && first + lane < state.size(); ++lane) {
      const std::size_t own = first + lane;
      const std::size_t other = s < list.first_indexed ? own + std::size_t(std::ptrdiff_t(slot.shift))
                                                       : slots.neighbour(block, slot, lane);
      const double stiffness = double(slots.row(slot.stiffness)[lane]);
      if (stiffness == 0.0 || other == own) continue;
      const double length = std::hypot(double(state.x()[other]) - double(state.x()[own]),
                                       double(state.y()[other]) - double(state.y()[own]),
                                       double(state.z()[other]) - double(state.z()[own]));
      measure.add_spring(length, stiffness, 2.0 * double(slots.row(slot.half_pull)[lane]));
    }
  }
  measure.energy /= double(slots.ends);
  return measure;
}

template SpringMeasure measure_gathered(const Slots<float>&, const State<float>&, std::size_t);
template SpringMeasure measure_gathered(const Slots<double>&, const State<double>&, std::size_t);

}  // namespace hooke
#endif
