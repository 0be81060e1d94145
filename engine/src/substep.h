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

/// The result of a step, that effects may still change.
template <class Real>
struct StepResult {
  const State<Real>& start;  ///< of the step
  State<Real>& next;         ///< packed copies included
  double h;                  ///< [s] of the step
  double time;               ///< [s] of the result
  double pending_kick;       ///< [s] that its velocities lack

  /// How long [s] forces have acted on velocities: not a step where a kick is left pending that was none
  /// before, as in the first step.
  double kick_time() const { return h + start.pending_kick - pending_kick; }
};

/// `last_kick` is the share of a step that velocities then lack.
template <class Real>
StepResult<Real> result_of(const Substep<Real>& last, double last_kick) {
  return {last.start, last.next, last.h, last.time_after, last_kick * last.h};
}

}  // namespace hooke
