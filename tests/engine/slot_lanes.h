#pragma once

#include <cstdint>

#include "model/slots.h"

/// The lanes of slots, read one by one as a test wants them: slowly, and with no word of how a kernel does.

namespace hooke::test {

/// A lane of a slot: its particle, the one that it leads to (itself where an indexed slot's lane is empty),
/// and its spring's constants, zero where a shift slot's lane is empty.
struct SlotLane {
  std::size_t own, other;
  double stiffness;  ///< [N/m]
  double pull;       ///< stiffness times rest length [N]
  double damping;    ///< [N s/m]

  bool has_spring() const { return own != other && (stiffness != 0.0 || damping != 0.0); }
};

/// Calls `visit` with every lane of a block's slots.
template <class Visit>
void for_each_lane(const Slots<double>& slots, std::size_t block, const Visit& visit) {
  const auto& list = slots.list(block);
  for (std::uint32_t s = list.first_shift; s < list.end; ++s) {
    const auto& slot = slots.slots[s];
    for (std::size_t lane = 0; lane < block_size; ++lane) {
      const std::size_t own = block * block_size + lane;
      const std::size_t other =
          s < list.first_indexed ? own + std::size_t(slot.shift) : slots.neighbour(block, slot, lane);
      visit(SlotLane{own, other, slots.row(slot.stiffness)[lane], 2.0 * slots.row(slot.half_pull)[lane],
                     slots.damped ? 4.0 * slots.row(slot.quarter_damping)[lane] : 0.0});
    }
  }
}

/// Calls `visit` with every lane that has a spring, of all blocks.
template <class Visit>
void for_each_spring_lane(const Slots<double>& slots, const Visit& visit) {
  for (std::size_t block = 0; block < slots.list_of_block.size(); ++block) {
    for_each_lane(slots, block, [&](const SlotLane& lane) {
      if (lane.has_spring()) visit(lane);
    });
  }
}

}  // namespace hooke::test
