#pragma once

#include "block.h"
#include "kernels/spring.h"
#include "model/slots.h"

namespace hooke {

/// Sums the forces of all springs of one block's particles: `force` is set, not added to.
template <class Real>
void gather_springs(const Slots<Real>& slots, const State<Real>& state, std::size_t block,
                    BlockForce<Real>& force);

/// What the springs of one block's particles hold, counting half of each spring's energy.
template <class Real>
SpringMeasure measure_gathered(const Slots<Real>& slots, const State<Real>& state, std::size_t block);

}  // namespace hooke
