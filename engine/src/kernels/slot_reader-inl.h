// Included once for each instruction set, after hwy/foreach_target.h.

#if defined(HOOKE_SLOT_READER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HOOKE_SLOT_READER_INL
#undef HOOKE_SLOT_READER_INL
#else
#define HOOKE_SLOT_READER_INL
#endif

#include <hwy/highway.h>

#include "kernels/packed-inl.h"
#include "kernels/spring-inl.h"
#include "model/slots.h"
#include "state.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

/// Reads what the slots of a block say, for the lanes of one vector: the ends of springs and their
/// coefficients. It copies pointers, which no store through another can then make to be read again.
template <class Real, bool damped, bool with_velocities, class Offset>
class SlotReader {
 public:
  using D = hn::CappedTag<Real, block_size>;
  using V = hn::Vec<D>;
  using Slot = typename Slots<Real>::Slot;

  /// Positions of some particles and, where they are wanted, their velocities.
  struct Ends {
    Vector3<V> position, velocity;
  };

  SlotReader(const Slots<Real>& slots, const State<Real>& state)
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

  HWY_INLINE const Slot& slot(std::uint32_t number) const { return slots_[number]; }

  /// Of an indexed slot: where the neighbours of the lanes from `lane` on are.
  HWY_INLINE const Offset* offsets(const Slot& slot, std::size_t lane) const {
    return offsets_ + std::size_t(slot.neighbours) * block_size + lane;
  }

  /// The particles from `i` on.
  HWY_INLINE Ends at(std::size_t i) const {
    Ends ends;
    ends.position = load3(D(), x_ + i, y_ + i, z_ + i);
    if constexpr (with_velocities) ends.velocity = load3(D(), vx_ + i, vy_ + i, vz_ + i);
    return ends;
  }

  /// The neighbours of some lanes of the block that begins at particle `block`.
  HWY_INLINE Ends at(std::size_t block, const Offset* offsets) const {
    const std::size_t base = block * packed_width;
    Ends ends;
    ends.position = load_packed(D(), packed_positions_ + base, offsets);
    if constexpr (with_velocities) ends.velocity = load_packed(D(), packed_velocities_ + base, offsets);
    return ends;
  }

  /// The coefficients of the springs at the lanes from `lane` on.
  HWY_INLINE SpringRows<V> rows(const Slot& slot, std::size_t lane) const {
    SpringRows<V> rows;
    rows.stiffness = row(slot.stiffness, lane);
    rows.half_pull = row(slot.half_pull, lane);
    if constexpr (damped) rows.quarter_damping = row(slot.quarter_damping, lane);
    return rows;
  }

  /// The force of the springs on their other ends, as a factor and the vector that it is to be multiplied by.
  struct Force {
    V factor;
    Vector3<V> apart;
  };

  HWY_INLINE static Force force_on_other(const Ends& own, const Ends& other, const SpringRows<V>& rows) {
    const Vector3<V> apart = own.position - other.position;
    Vector3<V> velocity;
    if constexpr (damped) velocity = own.velocity - other.velocity;
    return {spring_factor<damped>(D(), apart, velocity, rows), apart};
  }

 private:
  static const Offset* offsets_of(const Slots<Real>& slots) {
    if constexpr (sizeof(Offset) == sizeof(std::int16_t))
      return slots.short_offsets.data();
    else
      return slots.long_offsets.data();
  }

  HWY_INLINE V row(std::uint32_t number, std::size_t lane) const {
    return hn::Load(D(), values_ + std::size_t(number) * block_size + lane);
  }

  const Slot* slots_;
  const Real* values_;
  const Offset* offsets_;
  const Real *x_, *y_, *z_, *vx_, *vy_, *vz_;
  const Real *packed_positions_, *packed_velocities_;
};

template <bool damped, bool with_velocities, class Real, class Visit>
HWY_INLINE void with_reader_of(const Slots<Real>& slots, const State<Real>& state, const Visit& visit) {
  slots.long_offsets.empty() ? visit(SlotReader<Real, damped, with_velocities, std::int16_t>(slots, state))
                             : visit(SlotReader<Real, damped, with_velocities, std::int32_t>(slots, state));
}

/// Calls visit with the SlotReader for these slots, which reads velocities where springs are damped.
template <class Real, class Visit>
HWY_INLINE void with_reader(const Slots<Real>& slots, const State<Real>& state, const Visit& visit) {
  slots.damped ? with_reader_of<true, true>(slots, state, visit)
               : with_reader_of<false, false>(slots, state, visit);
}

/// Calls add(v, own, other, rows) for each spring of `vectors` vectors of particles, the first from particle
/// `first` on, each a block further on than the one before; all have the list of slots `list`. The first is
/// at lane `lane` of its block.
template <std::size_t vectors, class Reader, class List, class Add>
HWY_INLINE void for_each_spring(const Reader& reader, const List& list, std::size_t first, std::size_t lane,
                                const Add& add) {
  typename Reader::Ends own[vectors];
  for (std::size_t v = 0; v < vectors; ++v) own[v] = reader.at(first + v * block_size);
  for (std::uint32_t s = list.first_shift; s < list.first_indexed; ++s) {
    const auto& slot = reader.slot(s);
    const auto rows = reader.rows(slot, lane);
    for (std::size_t v = 0; v < vectors; ++v)
      add(v, own[v], reader.at(first + v * block_size + std::size_t(slot.shift)), rows);
  }
  if constexpr (vectors == 1) {
    for (std::uint32_t s = list.first_indexed; s < list.end; ++s) {
      const auto& slot = reader.slot(s);
      add(0, own[0], reader.at(first - lane, reader.offsets(slot, lane)), reader.rows(slot, lane));
    }
  }
}

/// Calls visit<vectors>(list, particle, lane) for the vectors of the blocks [begin, end): with two blocks at
/// once, from `particle` on, where a vector is a whole block and both have one list of shift slots, which
/// hides the latency of a vector; else for one vector, `lane` lanes behind its block's first.
template <class Real, class Visit>
HWY_INLINE void for_each_vector_of_blocks(const Slots<Real>& slots, std::size_t begin, std::size_t end,
                                          const Visit& visit) {
  const hn::CappedTag<Real, block_size> d;
  const std::uint32_t* const list_of_block = slots.list_of_block.data();
  const auto* const lists = slots.lists.data();
  for (std::size_t block = begin; block < end;) {
    const auto& list = lists[list_of_block[block]];
    const bool pair = hn::MaxLanes(d) == block_size && block + 1 < end &&
                      list_of_block[block + 1] == list_of_block[block] && list.first_indexed == list.end;
    if (pair) {
      visit.template operator()<2>(list, block * block_size, std::size_t{0});
      block += 2;
      continue;
    }
    for (std::size_t lane = 0; lane < block_size; lane += hn::Lanes(d))
      visit.template operator()<1>(list, block * block_size + lane, lane);
    ++block;
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#endif
