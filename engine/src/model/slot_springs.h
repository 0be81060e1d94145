#pragma once

#include <cstddef>

#include "model/slots.h"

namespace hooke {

/// What a slot says of one of its springs.
struct SlotSpring {
  double stiffness;  ///< k [N/m]
  double pull;       ///< k l0 [N]
};

/// Calls visit(own, other, spring) for the springs in the slots of a block, of which `own` is a particle: for
/// looking at each spring alone, where speed matters little.
template <class Real, class Visit>
void for_each_spring(const Slots<Real>& slots, std::size_t particles, std::size_t block, const Visit& visit) {
  const std::size_t first = block * block_size;
  const auto& list = slots.list(block);
  for (std::uint32_t s = list.first_shift; s < list.end; ++s) {
    const auto& slot = slots.slots[s];
    const Real* const stiffness = slots.row(slot.stiffness);
    const Real* const half_pull = slots.row(slot.half_pull);
    for (std::size_t lane = 0; lane < block_size && first + lane < particles; ++lane) {
      const std::size_t own = first + lane;
      const bool is_shift = s < list.first_indexed;
      // A lane without a spring may shift out of all particles.
      if (is_shift && stiffness[lane] == Real(0)) continue;
      const std::size_t other =
          is_shift ? own + std::size_t(std::ptrdiff_t(slot.shift)) : slots.neighbour(block, slot, lane);
      if (other != own) visit(own, other, SlotSpring{double(stiffness[lane]), 2.0 * double(half_pull[lane])});
    }
  }
}

}  // namespace hooke
