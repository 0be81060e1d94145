#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include <hooke/report.h>
#include <hooke/simulation.h>

#include "forces.h"
#include "model/model.h"
#include "state.h"

namespace hooke {

/// What the sweeps of one step work on.
template <class Real>
struct Step {
  const State<Real>& now;
  State<Real>& next;
  double h;           ///< [s]
  double time_after;  ///< [s] of the next state
  Executor& executor;
  std::atomic<Index> first_bad{Report::none};  ///< lowest user's number with a value that is not finite
};

/// One pass over particles or springs: one or more stages, fused.
template <class Real>
struct Sweep {
  std::string name;
  std::vector<Stage> stages;
  std::function<void(Step<Real>&)> run;
};

/// What a scene needs in each step and nothing else: written once, for running, timing and showing.
template <class Real>
struct CompiledPlan {
  std::vector<Sweep<Real>> sweeps;
  Plan shown;
};

/// `model` and `forces` must live as long as the plan.
template <class Real>
CompiledPlan<Real> make_plan(const Settings& settings, const Model<Real>& model, Forces<Real>& forces,
                             std::size_t state_bytes);

}  // namespace hooke
