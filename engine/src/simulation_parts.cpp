#include "simulation_parts.h"

#include <algorithm>

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
      forces(scene, model),
      plan(make_plan(settings, model, forces)),
      workers(plan.tiles, executor->threads()),
      states(initial_state(scene, model), plan.states()),
      clock(settings.step, settings.max_steps_per_advance) {
  plan.shown.state_bytes = states.bytes();
  for (const Sweep<Real>& sweep : plan.sweeps) times.push_back({sweep.name, 0.0});
}

template <class Real>
Index Simulation<Real>::Parts::take_at_once(std::size_t count) {
  const PlanRun<Real> run{plan, workers, *executor, times};
  try {
    return hooke::take_steps(run, {time_at_step_0, steps, settings.step}, count, states);
  } catch (...) {
    // A callback of the user's threw: the newest state is whole, the next one and the force sums are not.
    forces.clear();
    states.drop();
    throw;
  }
}

template <class Real>
Report Simulation<Real>::Parts::take_steps(std::uint64_t count) {
  for (SweepTime& time : times) time.seconds = 0.0;
  Report report;
  std::uint64_t one_by_one = 0;  // steps to be taken one by one, as one of them went bad
  while (report.steps_taken < count && report.ok()) {
    const std::uint64_t left = count - report.steps_taken;
    const std::uint64_t tried = one_by_one > 0 ? 1 : std::min<std::uint64_t>(left, plan.most_steps_at_once);
    const Index bad = take_at_once(tried);
    if (bad == Report::none) {
      steps += tried;
      report.steps_taken += tried;
      one_by_one -= one_by_one > 0;
    } else if (tried > 1) {
      one_by_one = tried;
    } else {
      report.first_bad_particle = bad;
      report.flags |= flag_not_finite;
    }
  }
  report.step = steps + (report.ok() ? 0 : 1);
  report.time = states.now().time;
  report.sweeps = times;
  return report;
}

template struct Simulation<float>::Parts;
template struct Simulation<double>::Parts;

}  // namespace hooke
