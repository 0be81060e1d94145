#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <hooke/simulation.h>

#include "forces.h"
#include "measure.h"
#include "model/model.h"
#include "plan.h"
#include "state.h"

namespace hooke {

/// What a simulation owns, in the order in which it is made.
template <class Real>
struct Simulation<Real>::Parts {
  Settings settings;
  std::shared_ptr<Executor> executor;
  Model<Real> model;
  Forces<Real> forces;
  State<Real> now, other;  ///< `other` is the state before, and the place for the next one
  CompiledPlan<Real> plan;
  Clock clock;
  std::uint64_t steps = 0;
  double time_at_step_0 = 0.0;  ///< [s] not zero after a snapshot from steps of another length
  std::vector<SweepTime> times;

  Parts(const Scene& scene, Settings given);

  /// Takes up to `count` steps; stops before one that goes bad, and reports it.
  Report take_steps(std::uint64_t count);

 private:
  /// Takes one step and returns Report::none, or returns the particle that went bad and stays in the state
  /// before.
  Index take_step();
};

}  // namespace hooke
