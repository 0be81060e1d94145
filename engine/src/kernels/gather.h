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

/// What the springs in one block's slots hold. Of a spring that is in two slots, each counts half the energy.
template <class Real>
SpringMeasure measure_gathered(const Slots<Real>& slots, const State<Real>& state, std::size_t block);

}  // namespace hooke
