#include "kernels/scatter.h"

#include <algorithm>
#include <atomic>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/scatter.cpp"
#include <hwy/foreach_target.h>

#include "kernels/flush_subnormals.h"
#include "kernels/slot_reader-inl.h"

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

/// Scatters the forces of the springs at `vectors` vectors of particles, the first from particle `first` on,
/// each a block further on than the one before; all have the list of slots `list`. The first is at lane
/// `lane` of its block.
template <std::size_t vectors, class Real, class Reader, class List>
HWY_INLINE void scatter(const Reader& reader, const List& list, std::size_t first, std::size_t lane,
                        const VectorAdds<Real>& sums) {
  using V = typename Reader::V;
  const typename Reader::D d;
  typename Reader::Ends own[vectors];
  Vector3<V> sum[vectors];
  for (std::size_t v = 0; v < vectors; ++v) {
    own[v] = reader.at(first + v * block_size);
    sum[v] = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  }
  const auto take_from_own = [&](std::size_t v, const auto& other, const auto& rows) HWY_ATTR {
    const auto force = Reader::force_on_other(own[v], other, rows);
    const Vector3<V> product{hn::Mul(force.factor, force.apart.x), hn::Mul(force.factor, force.apart.y),
                             hn::Mul(force.factor, force.apart.z)};
    sum[v] = sum[v] - product;
    return product;
  };
  for (std::uint32_t s = list.first_shift; s < list.first_indexed; ++s) {
    const auto& slot = reader.slot(s);
    const auto rows = reader.rows(slot, lane);
    for (std::size_t v = 0; v < vectors; ++v) {
      const std::size_t other = first + v * block_size + std::size_t(slot.shift);
      sums.add(other, take_from_own(v, reader.at(other), rows));
    }
  }
  if constexpr (vectors == 1) {
    for (std::uint32_t s = list.first_indexed; s < list.end; ++s) {
      const auto& slot = reader.slot(s);
      const auto* offsets = reader.offsets(slot, lane);
      sums.add(first - lane, offsets,
               take_from_own(0, reader.at(first - lane, offsets), reader.rows(slot, lane)));
    }
  }
  for (std::size_t v = 0; v < vectors; ++v) sums.add(first + v * block_size, sum[v]);
}

template <class Real>
void scatter_blocks(const Slots<Real>& slots, const State<Real>& state, std::size_t begin, std::size_t end,
                    const std::uint8_t* shared, ForceSums<Real>& sums) {
  const VectorAdds<Real> adds(sums, shared);
  with_reader(slots, state, [&](const auto& reader) HWY_ATTR {
    const auto scatter_list = [&]<std::size_t vectors>(const auto& list, std::size_t first, std::size_t lane)
                                  HWY_ATTR { scatter<vectors>(reader, list, first, lane, adds); };
    for_each_vector_of_blocks(slots, begin, end, scatter_list);
  });
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
  scatter_blocks(slots, state, begin, end, shared, sums);
}

void scatter_double(const Slots<double>& slots, const State<double>& state, std::size_t begin,
                    std::size_t end, const std::uint8_t* shared, ForceSums<double>& sums) {
  scatter_blocks(slots, state, begin, end, shared, sums);
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
