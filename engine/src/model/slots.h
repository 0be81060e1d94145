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

/// The springs as each particle sees them, for gathering forces: for each block of 16 particles a list of
/// slots, each with one neighbour and one spring for each lane. A spring is in two slots, once for each end.
///
/// - A shift slot joins particle i to i + shift in every lane: plain vector loads. On a grid all slots are of
/// this kind.
/// - An indexed slot has 16 neighbour numbers.
/// A lane without a spring has stiffness and damping zero; in an indexed slot its neighbour is itself.
///
/// Stiffness, rest length and damping are rows of 16 values. Equal rows are stored once, so a cloth of few
/// kinds of springs needs hardly more than 16 bytes for a slot.
template <class Real>
struct Slots {
  struct Slot {
    union {
      std::int32_t shift;        ///< of a shift slot
      std::uint32_t neighbours;  ///< of an indexed slot: its row in `neighbours`
    };
    std::uint32_t stiffness, rest_length, damping;  ///< rows in `values`
  };

  /// The slots of block b: shift slots from first_shift[b], then indexed slots from first_indexed[b] to
  /// first_shift[b + 1].
  std::vector<std::uint32_t> first_shift, first_indexed;
  std::vector<Slot> slots;
  std::vector<Index> neighbours;  ///< rows of 16, in the engine's order
  AlignedVector<Real> values;     ///< rows of 16: [N/m], [m], [N s/m]
  bool damped = false;

  const Real* row(std::uint32_t number) const { return values.data() + std::size_t(number) * block_size; }
  std::size_t shift_slots() const;
  std::size_t bytes() const;
};

template <class Real>
Slots<Real> make_slots(const Springs& springs, const Adjacency& adjacency, const Order& order,
                       Executor& executor);

}  // namespace hooke
