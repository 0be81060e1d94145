#pragma once

#include <cstdint>
#include <vector>

#include <hooke/executor.h>
#include <hooke/scene.h>

#include "aligned.h"
#include "model/adjacency.h"
#include "model/order.h"
#include "state.h"

namespace hooke {

/// The unit of the offsets of indexed slots: the largest that processors multiply an index by while they
/// load.
inline constexpr std::size_t offset_bytes = 8;

/// The offset from one particle's packed vector to the next one's.
template <class Real>
inline constexpr std::int32_t offsets_of_particle = std::int32_t(packed_width * sizeof(Real) / offset_bytes);

/// The ends at which a spring is in a slot: both, for gathering forces, or one, for scattering them. The
/// value counts the slots of a spring.
enum class SpringEnds { one = 1, both = 2 };

/// The springs as each particle sees them: for each block of 16 particles a list of slots, each with one
/// neighbour and one spring for each lane. A spring is in two slots, once for each end, or only in one
/// (model/spring_holders.h).
///
/// - A shift slot joins particle i to i + shift in every lane: plain vector loads. On a grid all slots are of
/// this kind.
/// - An indexed slot has 16 neighbours; it is read from the packed positions of the state.
/// A lane without a spring has coefficients zero; in an indexed slot its neighbour is itself.
///
/// The coefficients of the springs are rows of 16 values. Equal rows are stored once, and so are equal lists:
/// a cloth of few kinds of springs needs hardly more than 4 bytes for a block.
template <class Real>
struct Slots {
  struct Slot {
    union {
      std::int32_t shift;        ///< of a shift slot
      std::uint32_t neighbours;  ///< of an indexed slot: its row of offsets
    };
    std::uint32_t stiffness, half_pull, quarter_damping;  ///< rows in `values`
  };

  /// Shift slots [first_shift, first_indexed), then indexed slots up to `end`.
  struct List {
    std::uint32_t first_shift, first_indexed, end;
  };

  std::vector<std::uint32_t> list_of_block;
  std::vector<List> lists;
  std::vector<Slot> slots;
  /// Rows of 16: how far behind the packed vector of the block's first particle the neighbour's begins, in
  /// units of offset_bytes. Short where all fit, else long; the other is empty.
  AlignedVector<std::int16_t> short_offsets;
  AlignedVector<std::int32_t> long_offsets;
  /// Rows of 16: stiffness [N/m], half of stiffness times rest length [N], a quarter of damping [N s/m], as
  /// kernels/spring-inl.h wants them.
  AlignedVector<Real> values;
  bool damped = false;
  SpringEnds ends = SpringEnds::both;

  const List& list(std::size_t block) const { return lists[list_of_block[block]]; }
  const Real* row(std::uint32_t number) const { return values.data() + std::size_t(number) * block_size; }
  /// The particle behind a lane of an indexed slot of a block.
  std::size_t neighbour(std::size_t block, const Slot& slot, std::size_t lane) const {
    const std::size_t place = std::size_t(slot.neighbours) * block_size + lane;
    const std::int64_t offset = long_offsets.empty() ? short_offsets[place] : long_offsets[place];
    return std::size_t(std::int64_t(block * block_size) + offset / offsets_of_particle<Real>);
  }
  bool any_indexed() const { return !short_offsets.empty() || !long_offsets.empty(); }
  std::size_t bytes() const;
};

/// What is in the slots: for showing, and for judging an order.
struct SlotCount {
  std::size_t slots = 0;        ///< of all blocks
  std::size_t shift_slots = 0;  ///< of them
  std::size_t empty_lanes = 0;  ///< without a spring, of 16 in each slot

  double shift_share() const { return slots == 0 ? 0.0 : double(shift_slots) / double(slots); }
  double empty_share() const { return slots == 0 ? 0.0 : double(empty_lanes) / double(slots * block_size); }
};

template <class Real>
SlotCount count_slots(const Slots<Real>& slots, std::size_t springs);

template <class Real>
Slots<Real> make_slots(const Springs& springs, const Adjacency& adjacency, const Order& order,
                       Executor& executor, SpringEnds ends = SpringEnds::both);

}  // namespace hooke
