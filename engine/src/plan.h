#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include <hooke/report.h>
#include <hooke/simulation.h>

#include "forces.h"
#include "model/model.h"
#include "model/tiles.h"
#include "state.h"

namespace hooke {

/// One step, from the state now to the next one.
template <class Real>
struct Step {
  const State<Real>& now;
  State<Real>& next;
  double h;                       ///< [s]
  double time, time_after;        ///< [s] now, and of the next state
  std::atomic<Index>& first_bad;  ///< lowest user's number with a next value that is not finite
};

/// One pass over particles or springs: one or more stages, fused. It has one of the two functions.
template <class Real>
struct Sweep {
  std::string name;
  std::vector<Stage> stages;
  /// Does all at once, on the executor's threads.
  std::function<void(const Step<Real>&, Executor&)> run_all;
  /// Does the blocks [begin, end), and reads of other blocks only those that springs lead to.
  std::function<void(const Step<Real>&, std::size_t begin, std::size_t end)> run_blocks;
};

/// What a scene needs in each step and nothing else: written once, for running, timing and showing.
template <class Real>
struct CompiledPlan {
  std::vector<Sweep<Real>> sweeps;
  Tiles tiles;                         ///< of the blocks
  std::size_t most_steps_at_once = 1;  ///< more than one only where all is one sweep over blocks
  Plan shown;

  /// States that a run needs: see StateRing.
  std::size_t states() const { return most_steps_at_once == 1 ? 2 : 3; }
};

/// `model` and `forces` must live as long as the plan. The bytes of the state are left for who makes it.
template <class Real>
CompiledPlan<Real> make_plan(const Settings& settings, const Model<Real>& model, Forces<Real>& forces);

}  // namespace hooke
