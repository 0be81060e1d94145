#include "kernels/scatter.h"

#include <algorithm>
#include <atomic>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/scatter.cpp"
#include <hwy/foreach_target.h>

#include "kernels/flush_subnormals.h"
#include "kernels/packed-inl.h"
#include "kernels/spring-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

/// Adding zero would change no sum; most lanes of an atomic add have a spring, and some have none.
template <class Real>
HWY_INLINE void add_atomically(Real value, Real& sum) {
  if (value != Real(0)) std::atomic_ref<Real>(sum).fetch_add(value, std::memory_order_relaxed);
}

/// Adds vectors of forces to the sums, atomically where other threads may.
template <class Real>
class VectorAdds {
 public:
  using D = hn::CappedTag<Real, block_size>;
  using V = hn::Vec<D>;

  VectorAdds(ForceSums<Real>& sums, const std::uint8_t* shared)
      : x_(sums.x()), y_(sums.y()), z_(sums.z()), packed_(sums.packed()), shared_(shared) {}

  /// To the particles from `i` on.
  HWY_INLINE void add(std::size_t i, const Vector3<V>& force) const {
    if (shared_ != nullptr && (is_shared(i) || is_shared(i + hn::MaxLanes(D()) - 1))) {
      add_lanes_atomically(force.x, x_ + i);
      add_lanes_atomically(force.y, y_ + i);
      add_lanes_atomically(force.z, z_ + i);
    } else {
      add_lanes(force.x, x_ + i);
      add_lanes(force.y, y_ + i);
      add_lanes(force.z, z_ + i);
    }
  }

  /// To the neighbours of some lanes of the block that begins at particle `block`, one after the other:
  /// several may be the same particle.
  template <class Offset>
  HWY_INLINE void add(std::size_t block, const Offset* offsets, const Vector3<V>& force) const {
    const D d;
    alignas(cache_line) Real forces[hn::MaxLanes(D()) * packed_width];
    store_packed(d, force.x, force.y, force.z, forces);
    Real* const sums = packed_ + block * packed_width;
    constexpr auto unit = std::ptrdiff_t(offset_bytes / sizeof(Real));
    if (shared_ == nullptr) {
      for (std::size_t lane = 0; lane < hn::MaxLanes(D()); ++lane)
        add_particle(forces + lane * packed_width, sums + unit * offsets[lane]);
      return;
    }
    for (std::size_t lane = 0; lane < hn::MaxLanes(D()); ++lane) {
      const auto i = std::ptrdiff_t(block) + offsets[lane] / offsets_of_particle<Real>;
      Real* const sum = sums + unit * offsets[lane];
      is_shared(std::size_t(i)) ? add_particle_atomically(forces + lane * packed_width, sum)
                                : add_particle(forces + lane * packed_width, sum);
    }
  }

 private:
  HWY_INLINE bool is_shared(std::size_t i) const { return shared_[i / block_size] != 0; }

  HWY_INLINE static void add_lanes(V value, Real* sums) {
    const D d;
    hn::StoreU(hn::Add(hn::LoadU(d, sums), value), d, sums);
  }

  static HWY_NOINLINE void add_lanes_atomically(V value, Real* sums) {
    const D d;
    alignas(cache_line) Real lanes[hn::MaxLanes(D())];
    hn::Store(value, d, lanes);
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) add_atomically(lanes[lane], sums[lane]);
  }

  HWY_INLINE static void add_particle(const Real* force, Real* sum) {
    const hn::CappedTag<Real, packed_width> d;
    for (std::size_t axis = 0; axis < packed_width; axis += hn::Lanes(d))
      hn::Store(hn::Add(hn::Load(d, sum + axis), hn::Load(d, force + axis)), d, sum + axis);
  }

  HWY_INLINE static void add_particle_atomically(const Real* force, Real* sum) {
    for (std::size_t axis = 0; axis < 3; ++axis) add_atomically(force[axis], sum[axis]);
  }

  Real *x_, *y_, *z_, *packed_;
  const std::uint8_t* shared_;
};

/// Scatters the forces of the springs at the lanes of one vector in a block.
template <class Real, bool damped, class Offset>
class LaneScatter {
 public:
  using D = typename VectorAdds<Real>::D;
  using V = typename VectorAdds<Real>::V;

  LaneScatter(const Slots<Real>& slots, const State<Real>& state, const VectorAdds<Real>& sums)
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
        packed_velocities_(state.packed_velocities()),
        sums_(sums) {}

  /// The springs at `vectors` vectors of lanes, the first from particle `first` on, each a block further on
  /// than the one before; all have the list of slots `list`. The first is at lane `lane` of its block.
  template <std::size_t vectors>
  HWY_INLINE void scatter(const typename Slots<Real>::List& list, std::size_t first, std::size_t lane) const {
    Ends own[vectors];
    Vector3<V> sum[vectors];
    for (std::size_t v = 0; v < vectors; ++v) {
      own[v] = at(first + v * block_size);
      sum[v] = {hn::Zero(D()), hn::Zero(D()), hn::Zero(D())};
    }
    for (std::uint32_t s = list.first_shift; s < list.first_indexed; ++s) {
      const auto& slot = slots_[s];
      const SpringRows<V> springs = rows(slot, lane);
      for (std::size_t v = 0; v < vectors; ++v) {
        const std::size_t other = first + v * block_size + std::size_t(slot.shift);
        const Vector3<V> force = force_on_other(own[v], at(other), springs);
        sum[v] = sum[v] - force;
        sums_.add(other, force);
      }
    }
    if constexpr (vectors == 1) {
      for (std::uint32_t s = list.first_indexed; s < list.end; ++s) {
        const auto& slot = slots_[s];
        const Offset* offsets = offsets_ + std::size_t(slot.neighbours) * block_size + lane;
        const Vector3<V> force = force_on_other(own[0], at(first - lane, offsets), rows(slot, lane));
        sum[0] = sum[0] - force;
        sums_.add(first - lane, offsets, force);
      }
    }
    for (std::size_t v = 0; v < vectors; ++v) sums_.add(first + v * block_size, sum[v]);
  }

 private:
  /// Positions of some particles and, where springs are damped, their velocities.
  struct Ends {
    Vector3<V> position, velocity;
  };

  static const Offset* offsets_of(const Slots<Real>& slots) {
    if constexpr (sizeof(Offset) == sizeof(std::int16_t))
      return slots.short_offsets.data();
    else
      return slots.long_offsets.data();
  }

  HWY_INLINE Ends at(std::size_t i) const {
    Ends ends;
    ends.position = load3(D(), x_ + i, y_ + i, z_ + i);
    if constexpr (damped) ends.velocity = load3(D(), vx_ + i, vy_ + i, vz_ + i);
    return ends;
  }

  HWY_INLINE Ends at(std::size_t block, const Offset* offsets) const {
    const std::size_t base = block * packed_width;
    Ends ends;
    ends.position = load_packed(D(), packed_positions_ + base, offsets);
    if constexpr (damped) ends.velocity = load_packed(D(), packed_velocities_ + base, offsets);
    return ends;
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

  HWY_INLINE static Vector3<V> force_on_other(const Ends& own, const Ends& other, const SpringRows<V>& rows) {
    const Vector3<V> apart = own.position - other.position;
    Vector3<V> velocity;
    if constexpr (damped) velocity = own.velocity - other.velocity;
    const V factor = spring_factor<damped>(D(), apart, velocity, rows);
    return {hn::Mul(factor, apart.x), hn::Mul(factor, apart.y), hn::Mul(factor, apart.z)};
  }

  const typename Slots<Real>::Slot* slots_;
  const Real* values_;
  const Offset* offsets_;
  const Real *x_, *y_, *z_, *vx_, *vy_, *vz_;
  const Real *packed_positions_, *packed_velocities_;
  const VectorAdds<Real> sums_;
};

template <bool damped, class Offset, class Real>
void scatter(const Slots<Real>& slots, const State<Real>& state, std::size_t begin, std::size_t end,
             const VectorAdds<Real>& sums) {
  const typename VectorAdds<Real>::D d;
  const LaneScatter<Real, damped, Offset> lanes(slots, state, sums);
  for (std::size_t block = begin; block < end;) {
    const auto& list = slots.list(block);
    // Two blocks at once hide the latency of a vector that is a whole block.
    if (hn::MaxLanes(d) == block_size && block + 1 < end &&
        slots.list_of_block[block + 1] == slots.list_of_block[block] && list.first_indexed == list.end) {
      lanes.template scatter<2>(list, block * block_size, 0);
      block += 2;
      continue;
    }
    for (std::size_t lane = 0; lane < block_size; lane += hn::Lanes(d))
      lanes.template scatter<1>(list, block * block_size + lane, lane);
    ++block;
  }
}

template <class Real>
void scatter_any(const Slots<Real>& slots, const State<Real>& state, std::size_t begin, std::size_t end,
                 const std::uint8_t* shared, ForceSums<Real>& sums) {
  const VectorAdds<Real> adds(sums, shared);
  const auto scatter_with = [&]<class Offset>(Offset) {
    slots.damped ? scatter<true, Offset>(slots, state, begin, end, adds)
                 : scatter<false, Offset>(slots, state, begin, end, adds);
  };
  slots.long_offsets.empty() ? scatter_with(std::int16_t{}) : scatter_with(std::int32_t{});
}

/// Moves lanes away, and adds what the packed sums have to them.
template <class Real>
void take(const Strip<Real>& strip, ForceSums<Real>& sums, StripForce<Real>& force) {
  using D = typename VectorAdds<Real>::D;
  const D d;
  const auto move = [&](Real* sum) HWY_ATTR {
    const auto value = hn::LoadU(d, sum);
    hn::StoreU(hn::Zero(d), d, sum);
    return value;
  };
  for (std::size_t lane = 0; lane < strip.lanes; lane += hn::Lanes(d)) {
    const std::size_t i = strip.first + lane;
    auto x = move(sums.x() + i), y = move(sums.y() + i), z = move(sums.z() + i);
    if (Real* const packed = sums.packed(); packed != nullptr) {
      hn::Vec<D> packed_x, packed_y, packed_z, unused;
      hn::LoadInterleaved4(d, packed + i * packed_width, packed_x, packed_y, packed_z, unused);
      x = hn::Add(x, packed_x);
      y = hn::Add(y, packed_y);
      z = hn::Add(z, packed_z);
      std::fill_n(packed + i * packed_width, hn::Lanes(d) * packed_width, Real(0));
    }
    hn::Store(x, d, force.x + lane);
    hn::Store(y, d, force.y + lane);
    hn::Store(z, d, force.z + lane);
  }
}

}  // namespace

void take_float(const Strip<float>& strip, ForceSums<float>& sums, StripForce<float>& force) {
  take(strip, sums, force);
}

void take_double(const Strip<double>& strip, ForceSums<double>& sums, StripForce<double>& force) {
  take(strip, sums, force);
}

void scatter_float(const Slots<float>& slots, const State<float>& state, std::size_t begin, std::size_t end,
                   const std::uint8_t* shared, ForceSums<float>& sums) {
  scatter_any(slots, state, begin, end, shared, sums);
}

void scatter_double(const Slots<double>& slots, const State<double>& state, std::size_t begin,
                    std::size_t end, const std::uint8_t* shared, ForceSums<double>& sums) {
  scatter_any(slots, state, begin, end, shared, sums);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {
namespace {

HWY_EXPORT(scatter_float);
HWY_EXPORT(scatter_double);
HWY_EXPORT(take_float);
HWY_EXPORT(take_double);

}  // namespace

template <>
void scatter_springs(const Slots<float>& slots, const State<float>& state, std::size_t begin, std::size_t end,
                     const std::uint8_t* shared, ForceSums<float>& sums) {
  const FlushSubnormals flush;
  HWY_DYNAMIC_DISPATCH(scatter_float)(slots, state, begin, end, shared, sums);
}

template <>
void scatter_springs(const Slots<double>& slots, const State<double>& state, std::size_t begin,
                     std::size_t end, const std::uint8_t* shared, ForceSums<double>& sums) {
  const FlushSubnormals flush;
  HWY_DYNAMIC_DISPATCH(scatter_double)(slots, state, begin, end, shared, sums);
}

template <>
void take_sums(const Strip<float>& strip, ForceSums<float>& sums, StripForce<float>& force) {
  HWY_DYNAMIC_DISPATCH(take_float)(strip, sums, force);
}

template <>
void take_sums(const Strip<double>& strip, ForceSums<double>& sums, StripForce<double>& force) {
  HWY_DYNAMIC_DISPATCH(take_double)(strip, sums, force);
}

}  // namespace hooke
#endif
