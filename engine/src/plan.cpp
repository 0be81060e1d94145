#include "plan.h"

#include <algorithm>

#include "stability/step_division.h"

namespace hooke {
namespace {

/// Steps that are run at once without looking whether all went well. Where they did not, they are run again
/// one by one to find where, so this bounds what is lost.
constexpr std::size_t most_steps_at_once = 256;

/// What must be done for the whole state before forces are asked for.
template <class Real>
Sweep<Real> preparation_sweep(Forces<Real>& forces, const Scheme<Real>& scheme) {
  const auto run = [&forces, &scheme](const Substep<Real>& substep, Executor& executor) {
    if (scheme.needs_forces(substep.stage)) forces.prepare(substep.now, substep.time, executor);
  };
  return {forces.scatters() ? "springs" : "preparation", forces.preparation_stages(), run, {}};
}

/// What effects do to the result of a step, and what they remember of the step before.
template <class Real>
Sweep<Real> correction_sweep(Forces<Real>& forces, const Scheme<Real>& scheme) {
  const auto run = [&forces, &scheme](const Substep<Real>& substep, Executor& executor) {
    substep.next.memory = substep.start.memory;
    if (substep.stage + 1 == scheme.stages()) {
      forces.effects().correct(result_of(substep, scheme.last_kick()), executor);
    } else {
      substep.next.pairs = substep.start.pairs;  // a result gets its own from corrections
    }
  };
  return {"corrections", forces.effects().correction_stages(), run, {}};
}

Stage method_stage(const Method& method, std::size_t bytes) {
  return {std::string(to_string(method)),
          "",
          {"force", "position", "velocity", "inverse mass"},
          {"position", "velocity"},
          bytes};
}

template <class Real>
Stage pin_stage(const Model<Real>& model) {
  std::size_t bytes = model.moving_pins.capacity() * sizeof(MovingPin);
  for (const MovingPin& pin : model.moving_pins) bytes += pin.path.capacity() * sizeof(Keyframe);
  return {"moving pins", "", {"time"}, {"position", "velocity"}, bytes};
}

template <class Real>
Sweep<Real> particle_sweep(const Method& method, const Model<Real>& model, Forces<Real>& forces,
                           Scheme<Real>& scheme) {
  std::vector<Stage> stages = forces.strip_stages();
  stages.push_back(method_stage(method, model.inverse_mass.bytes() + scheme.bytes()));
  if (!model.moving_pins.empty()) stages.push_back(pin_stage(model));
  const bool corrects = forces.effects().corrects_strips();
  const bool holds = !model.held_between(0, model.particles()).empty() && scheme.stages() > 1;
  const auto run_awake = [&model, &forces, &scheme, corrects, holds](const Substep<Real>& substep,
                                                                     std::size_t begin, std::size_t end) {
    scheme.run_blocks(substep, model, forces, begin, end);
    const auto pins = pins_between(model.moving_pins, begin * block_size, end * block_size);
    move_pins(pins, substep.time_after, substep.next);
    if (holds && substep.stage + 1 < scheme.stages()) scheme.hold_blocks(substep, model, begin, end);
    if (corrects && substep.stage + 1 == scheme.stages())
      forces.effects().correct_strips(result_of(substep, scheme.last_kick()), begin, end);
  };
  const auto run = [&model, run_awake](const Substep<Real>& substep, std::size_t begin, std::size_t end) {
    model.for_each_awake_run(begin, end,
                             [&](std::size_t first, std::size_t last) { run_awake(substep, first, last); });
  };
  return {"particles", std::move(stages), {}, run};
}

template <class Real>
Sweep<Real> equation_sweep(const Model<Real>& model, const Forces<Real>& forces,
                           const SolvedSteps<Real>& solved) {
  std::vector<Stage> stages = forces.preparation_stages();
  for (Stage& stage : forces.strip_stages()) stages.push_back(std::move(stage));
  stages.push_back(solved.stage());
  stages.back().bytes += model.inverse_mass.bytes();
  if (!model.moving_pins.empty()) stages.push_back(pin_stage(model));
  for (Stage& stage : forces.effects().correction_stages()) stages.push_back(std::move(stage));
  return {"equations", std::move(stages), {}, {}};
}

/// Bytes that steps read and write for a block, to see how many blocks stay in a cache.
template <class Real>
std::size_t block_bytes(const Model<Real>& model, const Forces<Real>& forces, const Scheme<Real>& scheme) {
  const std::size_t blocks = block_count(model.particles());
  std::size_t arrays = model.inverse_mass.bytes() + scheme.bytes();
  for (const Stage& stage : forces.strip_stages()) arrays += stage.bytes;
  const std::size_t states = 2 + scheme.states_between();
  return states * State<Real>::bytes_of(block_size, packed_for(model)) + (blocks == 0 ? 0 : arrays / blocks);
}

/// What is shown of the sweeps: their stages, each with its sweep's name.
template <class Real>
std::vector<Stage> stages_of(const std::vector<Sweep<Real>>& sweeps) {
  std::vector<Stage> stages;
  for (const Sweep<Real>& sweep : sweeps) {
    for (const Stage& stage : sweep.stages) stages.emplace_back(stage).sweep = sweep.name;
  }
  return stages;
}

template <class Real>
std::string tiles_text(const CompiledPlan<Real>& plan) {
  const std::size_t substeps = plan.tiled ? plan.tiles.steps_in_pass : 1;
  const std::string what = plan.stages == 1 ? "step" : "stage";
  return std::to_string(plan.tiles.count()) + " of up to " +
         std::to_string(plan.tiles.tile_blocks * block_size) + " particles, " + std::to_string(substeps) +
         " " + what + (substeps == 1 ? "" : "s") + " in a pass over memory";
}

}  // namespace

template <class Real>
CompiledPlan<Real> make_plan(const Settings& settings, const Model<Real>& model, Forces<Real>& forces,
                             Scheme<Real>& scheme, const SolvedSteps<Real>* solved, std::uint64_t substeps) {
  CompiledPlan<Real> plan;
  plan.frames = model.frames.get();
  if (solved == nullptr && forces.needs_preparation())
    plan.sweeps.push_back(preparation_sweep(forces, scheme));
  plan.sweeps.push_back(solved != nullptr ? equation_sweep(model, forces, *solved)
                                          : particle_sweep(settings.method, model, forces, scheme));
  if (solved == nullptr && forces.effects().corrects())
    plan.sweeps.push_back(correction_sweep(forces, scheme));
  plan.stages = scheme.stages();
  plan.tiled = plan.sweeps.size() == 1 && !forces.effects().calls_user() && solved == nullptr;
  const bool controlled = scheme.controlled() != nullptr;
  const bool uses_before = solved != nullptr && solved->uses_before();
  plan.most_steps_at_once = plan.tiled && !controlled ? most_steps_at_once : 1;
  plan.states =
      plan.most_steps_at_once > 1 || controlled || substeps > 1 || uses_before || may_halve(settings) ? 3 : 2;
  plan.shown.substeps = substeps;
  plan.shown.stages = stages_of(plan.sweeps);
  plan.shown.model_bytes = model.order.bytes();
  plan.shown.order = model.order.reason();
  plan.shown.springs = forces.spring_layout();
  plan.tiles =
      make_tiles(block_count(model.particles()), std::max(model.spring_reach, forces.effects().reach()),
                 block_bytes(model, forces, scheme));
  plan.shown.tiles = tiles_text(plan);
  return plan;
}

template CompiledPlan<float> make_plan(const Settings&, const Model<float>&, Forces<float>&, Scheme<float>&,
                                       const SolvedSteps<float>*, std::uint64_t);
template CompiledPlan<double> make_plan(const Settings&, const Model<double>&, Forces<double>&,
                                        Scheme<double>&, const SolvedSteps<double>*, std::uint64_t);

}  // namespace hooke
