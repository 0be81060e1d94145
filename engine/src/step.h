#pragma once

#include <vector>

#include <hooke/report.h>

#include "plan.h"

namespace hooke {

/// Runs the plan once. `times` has one entry for each sweep, which gets the sweep's time added.
template <class Real>
void run_plan(const CompiledPlan<Real>& plan, Step<Real>& step, std::vector<SweepTime>& times);

}  // namespace hooke
