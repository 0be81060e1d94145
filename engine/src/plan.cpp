#include "plan.h"

#include "methods/euler.h"

namespace hooke {
namespace {

/// Steps that are run at once without looking whether all went well. Where they did not, they are run again
/// one by one to find where, so this bounds what is lost.
constexpr std::size_t most_steps_at_once = 256;

template <class Real>
Sweep<Real> spring_sweep(Forces<Real>& forces) {
  const auto run = [&forces](const Step<Real>& step, Executor& executor) {
    forces.scatter(step.now, executor);
  };
  return {"springs", {forces.spring_stage()}, run, {}};
}

Stage method_stage(const Method& method, std::size_t inverse_mass_bytes) {
  const auto name = std::visit([](const auto& data) { return std::string(data.name); }, method);
  return {name,
          "",
          {"force", "position", "velocity", "inverse mass"},
          {"position", "velocity"},
          inverse_mass_bytes};
}

template <class Real>
Stage pin_stage(const Model<Real>& model) {
  std::size_t bytes = model.moving_pins.capacity() * sizeof(MovingPin);
  for (const MovingPin& pin : model.moving_pins) bytes += pin.path.capacity() * sizeof(Keyframe);
  return {"moving pins", "", {"time"}, {"position", "velocity"}, bytes};
}

template <class Real>
Sweep<Real> particle_sweep(const Method& method, const Model<Real>& model, Forces<Real>& forces) {
  std::vector<Stage> stages = forces.strip_stages();
  stages.push_back(method_stage(method, model.inverse_mass.bytes()));
  if (!model.moving_pins.empty()) stages.push_back(pin_stage(model));
  const auto run = [method, &model, &forces](const Step<Real>& step, std::size_t begin, std::size_t end) {
    std::visit([&](const auto& data) { euler_blocks(data, model, forces, step, begin, end); }, method);
    const auto pins = pins_between(model.moving_pins, begin * block_size, end * block_size);
    move_pins(pins, step.time_after, step.next);
  };
  return {"particles", std::move(stages), {}, run};
}

/// Bytes that steps read and write for a block, to see how many blocks stay in a cache.
template <class Real>
std::size_t block_bytes(const Model<Real>& model, const Forces<Real>& forces) {
  const std::size_t blocks = block_count(model.particles());
  std::size_t constant = model.inverse_mass.bytes();
  for (const Stage& stage : forces.strip_stages()) constant += stage.bytes;
  const std::size_t two_states = 2 * State<Real>::bytes_of(block_size, packed_for(model));
  return two_states + (blocks == 0 ? 0 : constant / blocks);
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
  const std::size_t steps = plan.most_steps_at_once == 1 ? 1 : plan.tiles.steps_in_pass;
  return std::to_string(plan.tiles.count()) + " of up to " +
         std::to_string(plan.tiles.tile_blocks * block_size) + " particles, " + std::to_string(steps) +
         (steps == 1 ? " step" : " steps") + " in a pass over memory";
}

}  // namespace

template <class Real>
CompiledPlan<Real> make_plan(const Settings& settings, const Model<Real>& model, Forces<Real>& forces) {
  CompiledPlan<Real> plan;
  if (forces.scatters()) plan.sweeps.push_back(spring_sweep(forces));
  plan.sweeps.push_back(particle_sweep(settings.method, model, forces));
  const bool one_sweep = plan.sweeps.size() == 1 && !forces.calls_user();
  plan.most_steps_at_once = one_sweep ? most_steps_at_once : 1;
  plan.shown.stages = stages_of(plan.sweeps);
  plan.shown.model_bytes = model.order.bytes();
  plan.shown.order = model.order.reason();
  plan.shown.springs = forces.spring_layout();
  plan.tiles = make_tiles(block_count(model.particles()), model.spring_reach, block_bytes(model, forces));
  plan.shown.tiles = tiles_text(plan);
  return plan;
}

template CompiledPlan<float> make_plan(const Settings&, const Model<float>&, Forces<float>&);
template CompiledPlan<double> make_plan(const Settings&, const Model<double>&, Forces<double>&);

}  // namespace hooke
