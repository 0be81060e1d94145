#pragma once

#include <atomic>

#include "state.h"

namespace hooke {

/// One stage of a step: from the forces of one state to the state of the next stage, or the result.
template <class Real>
struct Substep {
  std::size_t stage;              ///< of the method's
  const State<Real>& start;       ///< of the step
  const State<Real>& now;         ///< whose forces are taken
  State<Real>& next;              ///< what is computed
  double h;                       ///< [s] of the whole step
  double pending_kick;            ///< [s] that the velocities of `now` lack; see State
  double time, time_after;        ///< [s] of `now` and `next`
  std::atomic<Index>& first_bad;  ///< lowest user's number with a next value that is not finite
};

/// The result of a step, that effects may still change. Its velocities lack State::pending_kick.
template <class Real>
struct StepResult {
  const State<Real>& start;  ///< of the step
  State<Real>& next;         ///< packed copies included
  double h;                  ///< [s] of the step
  double time;               ///< [s] of the result
};

template <class Real>
StepResult<Real> result_of(const Substep<Real>& last) {
  return {last.start, last.next, last.h, last.time_after};
}

}  // namespace hooke
