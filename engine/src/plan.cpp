#include "plan.h"

#include "methods/euler.h"

namespace hooke {
namespace {

/// Blocks that one thread takes at a time.
constexpr std::size_t block_grain = 64;

template <class Real>
Sweep<Real> spring_sweep(Forces<Real>& forces) {
  return {"springs", [&forces](Step<Real>& step) { forces.scatter(step.now, step.executor); }};
}

template <class Real>
Sweep<Real> particle_sweep(const Method& method, const Model<Real>& model, Forces<Real>& forces) {
  const auto run = [method, &model, &forces](Step<Real>& step) {
    step.executor.parallel_for(
        block_count(model.particles()), block_grain, [&](std::size_t begin, std::size_t end) {
          const auto euler = [&](const auto& data) {
            euler_blocks(data, model, forces, step.now, step.h, begin, end, step.next, step.first_bad);
          };
          std::visit(euler, method);
        });
  };
  return {"particles", run};
}

template <class Real>
Sweep<Real> pin_sweep(const Model<Real>& model) {
  return {"pins", [&model](Step<Real>& step) { move_pins(model.moving_pins, step.next); }};
}

Stage method_stage(const Method& method) {
  const auto name = std::visit([](const auto& data) { return std::string(data.name); }, method);
  return {name, "particles", {"force", "position", "velocity", "inverse mass"}, {"position", "velocity"}, 0};
}

template <class Real>
Stage pin_stage(const Model<Real>& model) {
  std::size_t bytes = model.moving_pins.capacity() * sizeof(MovingPin);
  for (const MovingPin& pin : model.moving_pins) bytes += pin.path.capacity() * sizeof(Keyframe);
  return {"moving pins", "pins", {"time"}, {"position", "velocity"}, bytes};
}

}  // namespace

template <class Real>
CompiledPlan<Real> make_plan(const Settings& settings, const Model<Real>& model, Forces<Real>& forces,
                             std::size_t state_bytes) {
  CompiledPlan<Real> plan;
  plan.shown.state_bytes = state_bytes;
  plan.shown.model_bytes = model.order.bytes() + model.inverse_mass.capacity() * sizeof(Real);
  plan.shown.order = model.order.reason();
  plan.shown.springs = forces.spring_layout();
  plan.shown.stages = forces.stages();
  if (forces.scatters()) plan.sweeps.push_back(spring_sweep(forces));
  plan.sweeps.push_back(particle_sweep(settings.method, model, forces));
  plan.shown.stages.push_back(method_stage(settings.method));
  if (!model.moving_pins.empty()) {
    plan.sweeps.push_back(pin_sweep(model));
    plan.shown.stages.push_back(pin_stage(model));
  }
  return plan;
}

template CompiledPlan<float> make_plan(const Settings&, const Model<float>&, Forces<float>&, std::size_t);
template CompiledPlan<double> make_plan(const Settings&, const Model<double>&, Forces<double>&, std::size_t);

}  // namespace hooke
