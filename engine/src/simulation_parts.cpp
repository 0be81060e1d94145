#include "simulation_parts.h"

#include <algorithm>
#include <chrono>

#include "model/precision.h"
#include "scene/scene_size.h"
#include "stability/step_division.h"
#include "step.h"

namespace hooke {
namespace {

std::shared_ptr<Executor> executor_of(const Settings& settings) {
  return settings.executor ? settings.executor : make_tbb_executor(settings.threads);
}

/// The bounds of a scene that can be simulated with these settings; throws SceneError with every fault if it
/// cannot.
template <class Real>
StepBounds validated(const Scene& scene, const Settings& settings) {
  CheckedScene checked = check(scene, settings);
  if (checked.faults.empty()) checked.faults = validate_precision<Real>(scene);
  if (!checked.faults.empty()) throw SceneError(std::move(checked.faults));
  return checked.bounds;
}

template <class Real>
std::optional<SolvedSteps<Real>> solved_steps(const Method& method, const SolverContext<Real>& context) {
  if (!solves_equations(method)) return {};
  return std::optional<SolvedSteps<Real>>(std::in_place, method, context);
}

template <class Real>
State<Real> start_of(const Scene& scene, const Model<Real>& model, const Forces<Real>& forces) {
  State<Real> start = initial_state(scene, model);
  start.memory = forces.effects().initial_memory();
  start.pairs.resize(forces.effects().pair_lists());
  return start;
}

}  // namespace

template <class Real>
Simulation<Real>::Parts::Parts(const Scene& scene, Settings given)
    : Parts(scene, given, validated<Real>(scene, given), executor_of(given),
            std::make_shared<PreparedMeshes>()) {}

template <class Real>
Simulation<Real>::Parts::Parts(const Scene& scene, Settings given, const StepBounds& bounds,
                               std::shared_ptr<Executor> threads, std::shared_ptr<PreparedMeshes> meshes)
    : settings(std::move(given)),
      stability(scene, bounds),
      substeps(substeps_of(stability.bounds, settings)),
      executor(std::move(threads)),
      model(scene, settings.accumulation, *executor, solves_equations(settings.method), std::move(meshes)),
      forces(scene, model),
      scheme(settings.method, model.particles()),
      solved(solved_steps<Real>(settings.method, {scene, model, forces, *executor})),
      plan(make_plan(settings, model, forces, scheme, solved ? &*solved : nullptr, substeps)),
      workers(plan.tiles, executor->threads()),
      states(start_of(scene, model, forces), plan.states),
      between(scheme.states_between(), states.now()),
      whole(states.now(), scheme.last_kick() != 0.0),
      clock(settings.step, settings.max_steps_per_advance) {
  if (const auto* method = std::get_if<DormandPrince>(&settings.method)) {
    controlled.emplace(*method, scene_size(scene), *scheme.controlled(), model, forces, *executor,
                       states.now());
  }
  if (is_watched(scene, settings)) {
    watch.emplace(scene, model, *executor, settings.step, states.now());
    begin_watch();
  }
  plan.shown.state_bytes = states.bytes() + whole.bytes() + (watch ? watch->bytes() : 0);
  for (const State<Real>& state : between) plan.shown.state_bytes += state.bytes();
  for (const Sweep<Real>& sweep : plan.sweeps) times.push_back({sweep.name, 0.0});
  for (const Effect& effect : scene.effects) {
    if (const auto* sleep = std::get_if<Sleep>(&effect)) begin_sleep(*sleep);
  }
}

/// With no more room than for one more.
template <class Real>
void Simulation<Real>::Parts::show_between_steps(Stage stage, std::string_view sweep) {
  plan.shown.stages.reserve(plan.shown.stages.size() + 1);
  plan.shown.stages.push_back(std::move(stage));
  times.reserve(times.size() + 1);
  times.push_back({sweep, 0.0});
}

template <class Real>
Energy Simulation<Real>::Parts::energy() {
  const State<Real>& now = whole_state();
  forces.effects().prepare(now, now.time, *executor);
  const ParticleSums sums = sum_particles(model, forces, now, *executor);
  return {sums.kinetic, forces.measure_springs(states.now(), *executor).energy, sums.external};
}

template <class Real>
template <class Attempt>
auto Simulation<Real>::Parts::attempt(const Attempt& attempt) {
  whole.forget();
  try {
    return attempt();
  } catch (...) {
    forces.clear();  // sums that no block took
    states.drop();
    if (controlled) controlled->restart(0.0, 1.0);
    if (solved) solved->forget();
    throw;
  }
}

template <class Real>
Index Simulation<Real>::Parts::take_at_once(std::size_t count) {
  const Index bad = attempt([&] {
    return with_all_met_awake(
        [&] { return hooke::take_steps(run(), substep_times(0), 0, count * substeps, states); });
  });
  if (bad == Report::none) {
    states.advance(count * substeps);
  } else {
    states.drop();
  }
  return bad;
}

template <class Real>
Index Simulation<Real>::Parts::take_substeps(std::size_t most_at_once) {
  Index bad = Report::none;
  for (std::uint64_t taken = 0; taken < substeps && bad == Report::none;) {
    const auto tried = std::min<std::uint64_t>(substeps - taken, most_at_once);
    bad = hooke::take_steps(run(), substep_times(taken), taken, tried, states);
    taken += tried;
  }
  return bad;
}

template <class Real>
Index Simulation<Real>::Parts::take_divided() {
  const auto take_them = [&] {
    const Index found = take_substeps(plan.most_steps_at_once);
    return found == Report::none || plan.most_steps_at_once == 1 ? found : take_substeps(1);
  };
  const Index bad = attempt([&] { return with_all_met_awake(take_them); });
  if (bad == Report::none) {
    states.advance_as_one(substeps);
  } else {
    states.drop();
  }
  return bad;
}

template <class Real>
std::uint64_t Simulation<Real>::Parts::steps_at_once(std::uint64_t left) const {
  if (substeps == 1) return std::min<std::uint64_t>(left, plan.most_steps_at_once);
  // The last one is taken apart, so that the state before it is kept.
  const std::uint64_t fitting = plan.most_steps_at_once / substeps;
  return std::max<std::uint64_t>(1, std::min(left - 1, fitting));
}

template <class Real>
void Simulation<Real>::Parts::take_fixed_steps(std::uint64_t count, Report& report) {
  std::uint64_t one_by_one = 0;  // steps to be taken one by one, as one of them went bad
  while (report.steps_taken < count && report.ok()) {
    const std::uint64_t tried = one_by_one > 0 ? 1 : steps_at_once(count - report.steps_taken);
    const Index bad = tried == 1 && substeps > 1 ? take_divided() : take_at_once(tried);
    if (bad == Report::none) {
      steps += tried;
      report.steps_taken += tried;
      report.force_evaluations += tried * substeps * plan.stages;
      one_by_one -= one_by_one > 0;
    } else if (tried > 1) {
      one_by_one = tried;
    } else {
      report.first_bad_particle = bad;
      report.flags |= flag_not_finite;
    }
  }
}

template <class Real>
void Simulation<Real>::Parts::take_controlled_steps(std::uint64_t count, Report& report) {
  using Outcome = typename ControlledSteps<Real>::Outcome;
  while (report.steps_taken < count && report.ok()) {
    const StepTimes times_of_steps{time_at_step_0, steps, settings.step};
    const auto result = attempt([&] { return controlled->go(run(), times_of_steps.after(1), states); });
    report.force_evaluations += result.evaluations;
    report.rejected_steps += result.rejected;
    if (result.outcome == Outcome::reached) {
      ++steps;
      ++report.steps_taken;
    } else {
      states.drop();
      report.first_bad_particle = result.bad;
      report.flags |= result.outcome == Outcome::not_finite ? flag_not_finite : flag_step_too_small;
    }
  }
}

template <class Real>
void Simulation<Real>::Parts::take_solved_steps(std::uint64_t count, Report& report) {
  const auto start = std::chrono::steady_clock::now();
  while (report.steps_taken < count && report.ok()) {
    const StepTimes at{time_at_step_0, steps, settings.step};
    const StageResult result = attempt([&] {
      return with_all_met_awake(
          [&] { return solved->take(settings.step, states.now().time, at.after(1), states); });
    });
    report.force_evaluations += result.force_evaluations;
    report.solver_iterations += result.iterations;
    report.linear_iterations += result.linear_iterations;
    report.first_bad_particle = solved->first_bad(states);
    if (report.first_bad_particle != Report::none) {
      states.drop();
      solved->forget();
      report.flags |= flag_not_finite;
      break;
    }
    states.advance(1);
    solved->remember();
    ++steps;
    ++report.steps_taken;
    report.residual = std::max(report.residual, result.residual);
    if (!result.converged) report.flags |= flag_not_converged;
  }
  times.front().seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <class Real>
void Simulation<Real>::Parts::begin_report() {
  for (SweepTime& time : times) time.seconds = 0.0;
  forces.effects().forget_forces(states.now());
}

template <class Real>
void Simulation<Real>::Parts::take_steps(std::uint64_t count, Report& report) {
  if (sleepers) {
    take_sleeping_steps(count, report);
  } else {
    take_awake_steps(count, report);
  }
}

template <class Real>
void Simulation<Real>::Parts::take_awake_steps(std::uint64_t count, Report& report) {
  if (controlled) {
    take_controlled_steps(count, report);
  } else if (solved) {
    take_solved_steps(count, report);
  } else {
    take_watched_steps(count, report);
  }
}

template <class Real>
void Simulation<Real>::Parts::end_report(Report& report) {
  if ((report.flags & flag_restored) == 0) report.step = steps + (report.ok() ? 0 : 1);
  report.time = states.now().time;
  report.sweeps = times;
  if (sleepers) report.particles_asleep = sleepers->particles_asleep();
  forces.effects().tell(report);
}

template <class Real>
Report Simulation<Real>::Parts::take_steps(std::uint64_t count) {
  begin_report();
  Report report;
  take_steps(count, report);
  end_report(report);
  return report;
}

template struct Simulation<float>::Parts;
template struct Simulation<double>::Parts;

}  // namespace hooke
