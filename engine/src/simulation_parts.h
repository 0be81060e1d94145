#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <hooke/simulation.h>

#include "controlled_steps.h"
#include "forces.h"
#include "measure.h"
#include "methods/whole_state.h"
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
  Scheme<Real> scheme;
  CompiledPlan<Real> plan;
  TileWorkers workers;
  StateRing<Real> states;
  std::vector<State<Real>> between;  ///< states between the stages of a step
  WholeState<Real> whole;
  std::optional<ControlledSteps<Real>> controlled;  ///< of a method with error control
  Clock clock;
  std::uint64_t steps = 0;
  double time_at_step_0 = 0.0;  ///< [s] not zero after a snapshot from steps of another length
  std::vector<SweepTime> times;

  Parts(const Scene& scene, Settings given);

  /// Takes up to `count` steps; stops before one that goes bad, and reports it.
  Report take_steps(std::uint64_t count);

  /// The newest state with whole velocities.
  const State<Real>& whole_state() { return whole.of(states.now(), model, forces, *executor); }

 private:
  PlanRun<Real> run() { return {plan, scheme, workers, *executor, between, times}; }

  /// Takes as many steps as go well, up to `count`.
  void take_fixed_steps(std::uint64_t count, Report& report);
  void take_controlled_steps(std::uint64_t count, Report& report);

  /// Takes `count` steps, at most plan.most_steps_at_once, and returns Report::none; or returns a particle
  /// that went bad and stays in the state before.
  Index take_at_once(std::size_t count);

  /// Runs a step. Where it throws, as a callback of the user's may, the newest state stays whole.
  template <class Attempt>
  auto attempt(const Attempt& attempt);
};

}  // namespace hooke
