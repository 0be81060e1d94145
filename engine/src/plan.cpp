#include "plan.h"

#include "methods/euler.h"

namespace hooke {
namespace {

/// Blocks that one thread takes at a time.
constexpr std::size_t block_grain = 64;

template <class Real>
Sweep<Real> spring_sweep(Forces<Real>& forces) {
  const auto run = [&forces](Step<Real>& step) { forces.scatter(step.now, step.executor); };
  return {"springs", {forces.spring_stage()}, run};
}

Stage method_stage(const Method& method) {
  const auto name = std::visit([](const auto& data) { return std::string(data.name); }, method);
  return {name, "", {"force", "position", "velocity", "inverse mass"}, {"position", "velocity"}, 0};
}

template <class Real>
Sweep<Real> particle_sweep(const Method& method, const Model<Real>& model, Forces<Real>& forces) {
  std::vector<Stage> stages = forces.strip_stages();
  stages.push_back(method_stage(method));
  const auto run = [method, &model, &forces](Step<Real>& step) {
    step.executor.parallel_for(
        block_count(model.particles()), block_grain, [&](std::size_t begin, std::size_t end) {
          const auto euler = [&](const auto& data) {
            euler_blocks(data, model, forces, step.now, step.h, begin, end, step.next, step.first_bad);
          };
          std::visit(euler, method);
        });
  };
  return {"particles", std::move(stages), run};
}

template <class Real>
Stage pin_stage(const Model<Real>& model) {
  std::size_t bytes = model.moving_pins.capacity() * sizeof(MovingPin);
  for (const MovingPin& pin : model.moving_pins) bytes += pin.path.capacity() * sizeof(Keyframe);
  return {"moving pins", "", {"time"}, {"position", "velocity"}, bytes};
}

template <class Real>
Sweep<Real> pin_sweep(const Model<Real>& model) {
  return {
      "pins", {pin_stage(model)}, [&model](Step<Real>& step) { move_pins(model.moving_pins, step.next); }};
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

}  // namespace

template <class Real>
CompiledPlan<Real> make_plan(const Settings& settings, const Model<Real>& model, Forces<Real>& forces,
                             std::size_t state_bytes) {
  CompiledPlan<Real> plan;
  if (forces.scatters()) plan.sweeps.push_back(spring_sweep(forces));
  plan.sweeps.push_back(particle_sweep(settings.method, model, forces));
  if (!model.moving_pins.empty()) plan.sweeps.push_back(pin_sweep(model));
  plan.shown.stages = stages_of(plan.sweeps);
  plan.shown.state_bytes = state_bytes;
  plan.shown.model_bytes = model.order.bytes() + model.inverse_mass.capacity() * sizeof(Real);
  plan.shown.order = model.order.reason();
  plan.shown.springs = forces.spring_layout();
  return plan;
}

template CompiledPlan<float> make_plan(const Settings&, const Model<float>&, Forces<float>&, std::size_t);
template CompiledPlan<double> make_plan(const Settings&, const Model<double>&, Forces<double>&, std::size_t);

}  // namespace hooke
