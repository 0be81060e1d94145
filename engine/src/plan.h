#pragma once

#include <functional>
#include <string>
#include <vector>

#include <hooke/report.h>
#include <hooke/simulation.h>

#include "forces.h"
#include "methods/scheme.h"
#include "model/model.h"
#include "model/tiles.h"
#include "solve/solved_steps.h"
#include "substep.h"

namespace hooke {

/// One pass over particles or springs: one or more stages, fused. It has one of the two functions, or none
/// where the method solves equations and goes through it as often as that needs.
template <class Real>
struct Sweep {
  std::string name;
  std::vector<Stage> stages;
  /// Does all at once, on the executor's threads.
  std::function<void(const Substep<Real>&, Executor&)> run_all;
  /// Does the blocks [begin, end), and reads of other blocks only those that springs lead to.
  std::function<void(const Substep<Real>&, std::size_t begin, std::size_t end)> run_blocks;
};

/// What a scene needs in each stage of a step and nothing else: written once, for running, timing and
/// showing.
template <class Real>
struct CompiledPlan {
  std::vector<Sweep<Real>> sweeps;
  std::size_t stages = 1;              ///< of a step: each runs all sweeps
  Tiles tiles;                         ///< of the blocks
  bool tiled = false;                  ///< all is one sweep over blocks, which may go on to later stages
  std::size_t most_steps_at_once = 1;  ///< more than one only where it is tiled
  std::size_t states = 2;              ///< that a run needs: see StateRing
  Frames* frames = nullptr;            ///< the model's; null of a scene without
  Plan shown;
};

/// `model`, `forces` and `scheme` must live as long as the plan. `solved` is null where the method solves no
/// equations. Each step is taken in `substeps`. The bytes of the state are left for who makes it.
template <class Real>
CompiledPlan<Real> make_plan(const Settings& settings, const Model<Real>& model, Forces<Real>& forces,
                             Scheme<Real>& scheme, const SolvedSteps<Real>* solved, std::uint64_t substeps);

}  // namespace hooke
