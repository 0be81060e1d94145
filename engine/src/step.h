#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <hooke/report.h>

#include "parallel/tile_workers.h"
#include "plan.h"
#include "state_ring.h"

namespace hooke {

/// When the steps of a run are: the n-th state from now is at start + (now + n) h. A product, not a sum of
/// steps, as a sum drifts by a rounding error in each.
struct StepTimes {
  double start;          ///< [s]
  std::uint64_t now;     ///< steps taken since `start`
  double whole_step;     ///< [s]
  double divisions = 1;  ///< equal parts of the whole step, each of which is a step here

  double h() const { return whole_step / divisions; }  ///< [s]

  /// `share` of a step later still.
  double after(std::size_t steps, double share = 0.0) const {
    return start + (double(now + steps) + share) / divisions * whole_step;
  }
};

/// What runs the plan, and where its times go: one for each sweep, which gets the sweep's time added.
template <class Real>
struct PlanRun {
  const CompiledPlan<Real>& plan;
  const Scheme<Real>& scheme;
  TileWorkers& workers;
  Executor& executor;
  std::span<State<Real>> between;  ///< states between the stages of a step
  std::vector<SweepTime>& times;
};

/// Computes `count` steps, at most plan.most_steps_at_once, from the state `first` steps after the newest of
/// the ring, into those that come after it. Returns Report::none if all went well; if not, a particle that
/// went bad: the first one, by number, if `count` is one. Leaves it to the caller to advance the ring.
template <class Real>
Index take_steps(const PlanRun<Real>& run, const StepTimes& times, std::size_t first, std::size_t count,
                 StateRing<Real>& states);

}  // namespace hooke
