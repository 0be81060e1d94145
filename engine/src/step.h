#pragma once

#include <vector>

#include <hooke/report.h>

#include "parallel/tile_workers.h"
#include "plan.h"
#include "state_ring.h"

namespace hooke {

/// When the steps of a run are: the n-th state from now is at start + (n_now + n) h. A product, not a sum of
/// steps, as a sum drifts by a rounding error in each.
struct StepTimes {
  double start;       ///< [s]
  std::uint64_t now;  ///< steps taken since `start`
  double h;           ///< [s]

  double after(std::size_t steps) const { return start + double(now + steps) * h; }
};

/// What runs the plan, and where its times go: one for each sweep, which gets the sweep's time added.
template <class Real>
struct PlanRun {
  const CompiledPlan<Real>& plan;
  TileWorkers& workers;
  Executor& executor;
  std::vector<SweepTime>& times;
};

/// Computes `count` steps, at most plan.most_steps_at_once, from the newest state of the ring into its other
/// states, and advances it. Where a step goes bad the ring keeps its newest state; a particle that went bad
/// is returned: the first one, by number, if `count` is one. Report::none if all went well.
template <class Real>
Index take_steps(const PlanRun<Real>& run, const StepTimes& times, std::size_t count,
                 StateRing<Real>& states);

}  // namespace hooke
