#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <hooke/simulation.h>

#include "forces.h"
#include "measure.h"
#include "model/model.h"
#include "parallel/tile_workers.h"
#include "plan.h"
#include "state_ring.h"

namespace hooke {

/// What a simulation owns, in the order in which it is made.
template <class Real>
struct Simulation<Real>::Parts {
  Settings settings;
  std::shared_ptr<Executor> executor;
  Model<Real> model;
  Forces<Real> forces;
  CompiledPlan<Real> plan;
  TileWorkers workers;
  StateRing<Real> states;
  Clock clock;
  std::uint64_t steps = 0;
  double time_at_step_0 = 0.0;  ///< [s] not zero after a snapshot from steps of another length
  std::vector<SweepTime> times;

  Parts(const Scene& scene, Settings given);

  /// Takes up to `count` steps; stops before one that goes bad, and reports it.
  Report take_steps(std::uint64_t count);

 private:
  /// Takes `count` steps, at most plan.most_steps_at_once, and returns Report::none; or returns a particle
  /// that went bad and stays in the state before.
  Index take_at_once(std::size_t count);
};

}  // namespace hooke
