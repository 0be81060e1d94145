#pragma once

#include "frames/frames.h"
#include "substep.h"

namespace hooke {

/// What a frame carries is summed up in State::memory, from HeldParticle::memory on: a time [s], an impulse
/// [N s] and its moment [N m s].
inline constexpr std::size_t carried_values = 7;

template <class Real>
void add_carried(const FrameLoad& impulse, std::size_t memory, State<Real>& state) {
  Real* const sums = &state.memory[memory];
  for (Eigen::Index k = 0; k < 3; ++k) {
    sums[1 + k] += Real(impulse.force[k]);
    sums[4 + k] += Real(impulse.torque[k]);
  }
}

/// Another correction of the step pulls at a held particle with an impulse [N s].
template <class Real>
void carry(const HeldParticle& held, const Vec3& impulse, const StepResult<Real>& result) {
  const Vec3 place = result.start.position(held.particle).template cast<double>();
  const Vec3 arm = place - held.frame->origin(result.time - result.h);
  add_carried({impulse, arm.cross(impulse)}, held.memory, result.next);
}

}  // namespace hooke
