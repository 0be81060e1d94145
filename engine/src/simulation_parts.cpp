#include "simulation_parts.h"

#include "model/precision.h"
#include "step.h"

namespace hooke {
namespace {

std::shared_ptr<Executor> executor_of(const Settings& settings) {
  return settings.executor ? settings.executor : make_tbb_executor(settings.threads);
}

/// The settings, if they and the scene can be simulated; throws SceneError with every fault if not.
template <class Real>
Settings validated(const Scene& scene, Settings settings) {
  std::vector<Fault> faults = validate(scene, settings);
  if (faults.empty()) faults = validate_precision<Real>(scene);
  if (!faults.empty()) throw SceneError(std::move(faults));
  return settings;
}

}  // namespace

template <class Real>
Simulation<Real>::Parts::Parts(const Scene& scene, Settings given)
    : settings(validated<Real>(scene, std::move(given))),
      executor(executor_of(settings)),
      model(scene, settings.accumulation, *executor),
      forces(scene, model, settings.accumulation),
      now(initial_state(scene, model)),
      other(now),
      plan(make_plan(settings, model, forces, now.bytes() + other.bytes())),
      clock(settings.step, settings.max_steps_per_advance) {
  for (const Sweep<Real>& sweep : plan.sweeps) times.push_back({sweep.name, 0.0});
}

template <class Real>
Index Simulation<Real>::Parts::take_step() {
  // A product, not a sum of steps: a sum drifts by a rounding error in each.
  const double time_after = time_at_step_0 + double(steps + 1) * settings.step;
  Step<Real> step{now, other, settings.step, time_after, *executor};
  try {
    run_plan(plan, step, times);
  } catch (...) {
    // A callback of the user's threw: the state now is whole, the next one and the force sums are not.
    forces.clear();
    other = now;
    throw;
  }
  if (step.first_bad != Report::none) {
    other = now;
    return step.first_bad;
  }
  std::swap(now, other);
  ++steps;
  return Report::none;
}

template <class Real>
Report Simulation<Real>::Parts::take_steps(std::uint64_t count) {
  for (SweepTime& time : times) time.seconds = 0.0;
  Report report;
  while (report.steps_taken < count && report.ok()) {
    report.first_bad_particle = take_step();
    if (report.first_bad_particle == Report::none) {
      ++report.steps_taken;
    } else {
      report.flags |= flag_not_finite;
    }
  }
  report.step = steps + (report.ok() ? 0 : 1);
  report.time = now.time;
  report.sweeps = times;
  return report;
}

template struct Simulation<float>::Parts;
template struct Simulation<double>::Parts;

}  // namespace hooke
