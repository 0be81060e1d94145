#pragma once

#include "kernels/spring_measure.h"
#include "model/slots.h"
#include "strip.h"

namespace hooke {

/// Sums the forces of all springs of the particles in the blocks [begin, end), at most strip_blocks of them:
/// `force` is set, not added to. Where there are indexed slots the state must have packed positions, and if
/// springs are damped packed velocities.
template <class Real>
void gather_springs(const Slots<Real>& slots, const State<Real>& state, std::size_t begin, std::size_t end,
                    StripForce<Real>& force);

/// What the springs of one block's particles hold, counting half of each spring's energy.
template <class Real>
SpringMeasure measure_gathered(const Slots<Real>& slots, const State<Real>& state, std::size_t block);

}  // namespace hooke
