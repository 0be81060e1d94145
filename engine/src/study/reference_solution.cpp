#include "study/reference_solution.h"

#include <algorithm>
#include <limits>
#include <string>

#include "study/method_choice.h"
#include "study/position_error.h"
#include "study/reference_plan.h"
#include "study/reference_scales.h"

namespace hooke::study {
namespace {

/// Runs a reference to the horizon, or as far as it gets in its time; `at_tick` gets the run at each tick it
/// reaches.
template <class AtTick>
void solve(const Scene& scene, const StudySettings& settings, const ReferencePlan& plan, StudyClock& clock,
           std::size_t number, ReferenceSolution& solution, AtTick at_tick) {
  constexpr double overrun = 2.5;  // what is cut off is lost, so only where most of the budget would go
  const double deadline = clock.elapsed() + overrun * plan.seconds;
  SampledRun run(scene, settings, plan.run, clock);
  RunEnd end = RunEnd::reached;
  for (unsigned tick = 0; tick <= last_tick && end == RunEnd::reached; ++tick) {
    end = run.advance_to(tick, deadline);
    if (end != RunEnd::reached) break;
    solution.samples[number].push_back(run.sample(tick));
    if (is_output(tick)) at_tick(run, tick);
  }
  Reference& report = solution.report;
  report.choices[number] = choice_of(plan.run, run, settings);
  report.force_evaluations[number] = run.force_evaluations();
  report.seconds[number] = run.seconds();
  solution.broke_down = solution.broke_down || end == RunEnd::diverged;
  solution.stopped = solution.stopped || end == RunEnd::stopped;
  solution.seconds_each_evaluation = run.seconds() / std::max(1.0, double(run.force_evaluations()));
}

/// The first reference, whose positions are kept. Returns the last tick that it reached.
unsigned solve_first(const Scene& scene, const StudySettings& settings, const StepLimits& limits,
                     StudyClock& clock, ReferenceSolution& solution) {
  solution.positions.resize(last_tick + 1);
  solve(scene, settings, plan_of_chosen_steps(scene, settings, limits, clock), clock, 0, solution,
        [&](const SampledRun& run, unsigned tick) { run.copy_positions(solution.positions[tick]); });
  find_scales(scene, solution);
  if (solution.scene_size == 0.0) {
    throw SceneError({{"scene",
                       "has all its particles at one place and none moves, so there is no size to measure "
                       "errors by",
                       "give it something that moves"}});
  }
  return unsigned(solution.samples[0].size()) - (solution.samples[0].empty() ? 0u : 1u);
}

/// The second reference, compared with the first at each output.
void solve_second(const Scene& scene, const StudySettings& settings, const StepLimits& limits,
                  StudyClock& clock, unsigned first_reached, ReferenceSolution& solution) {
  solution.disagreement.assign(last_tick + 1, 0.0);
  std::vector<double> positions;
  double largest = 0.0;
  bool trusted = true;
  const auto compare = [&](const SampledRun& run, unsigned tick) {
    if (tick > first_reached) return;
    run.copy_positions(positions);
    const double difference =
        position_error(positions, solution.positions[tick], solution.free_particles).rms /
        solution.scene_size;
    solution.report.times.push_back(settings.horizon * tick / last_tick);
    solution.report.agreement.push_back(difference);
    largest = std::max({largest, difference, std::numeric_limits<double>::epsilon()});  // equal is not exact
    for (unsigned t = tick; t <= last_tick; ++t) solution.disagreement[t] = largest;
    solution.reached = tick;
    trusted = trusted && trust_factor * difference <= settings.tolerance;
    if (trusted) solution.trusted = tick;
  };
  solve(scene, settings, plan_of_fixed_steps(scene, settings, limits, clock), clock, 1, solution, compare);
}

}  // namespace

bool ReferenceSolution::reaches_horizon() const {
  return std::max(samples[0].size(), samples[1].size()) > last_tick;
}

const Sample& ReferenceSolution::expected(unsigned tick) const {
  for (const std::vector<Sample>& each : samples) {
    if (tick < each.size()) return each[tick];
  }
  return samples[0].back();
}

ReferenceSolution make_reference(const Scene& scene, const StudySettings& settings, const StepLimits& limits,
                                 StudyClock& clock) {
  ReferenceSolution solution;
  solution.free_particles = scene.particles.size() - scene.pins.size();
  const unsigned first_reached = solve_first(scene, settings, limits, clock, solution);
  solve_second(scene, settings, limits, clock, first_reached, solution);
  Reference& report = solution.report;
  report.reached = settings.horizon * solution.reached / last_tick;
  report.trusted_until = settings.horizon * solution.trusted / last_tick;
  for (const Sample& sample : solution.samples[solution.samples[1].size() > solution.samples[0].size()])
    report.energy.push_back({settings.horizon * sample.tick / last_tick, sample.energy});
  report.verdict = verdict(solution, settings);
  return solution;
}

}  // namespace hooke::study
