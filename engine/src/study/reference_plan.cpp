#include "study/reference_plan.h"

#include <algorithm>
#include <cmath>

#include "study/method_traits.h"

namespace hooke::study {
namespace {

// Shares of the budget: of a reference, and of the runs that are tried for it.
constexpr double reference_share = 0.12, trial_share = 0.06;

std::uint64_t whole_ticks(std::uint64_t steps) {
  return (steps + last_tick - 1) / last_tick * last_tick;
}

}  // namespace

ReferencePlan plan_of_chosen_steps(const Scene& scene, const StudySettings& settings,
                                   const StepLimits& limits, StudyClock& clock) {
  const double finest = std::max(1e-12, 1e-9 * settings.tolerance), coarsest = 1e-3 * settings.tolerance;
  const double tried = std::clamp(1e-6, finest, coarsest);
  RunPlan run{with_tolerance(DormandPrince{}, tried, settings.horizon), 0};
  run.steps = whole_ticks(limits.looks(run.method));
  SampledRun trial(scene, settings, run, clock);
  trial.advance_to(last_tick, clock.elapsed() + trial_share * settings.budget);
  const double share_done = std::max(trial.time() / settings.horizon, 1e-9);
  const double seconds = reference_share * settings.budget;
  const double affordable = tried * std::pow(trial.seconds() / share_done / seconds, 5.0);
  run.method = with_tolerance(run.method, std::clamp(affordable, finest, coarsest), settings.horizon);
  return {run, seconds};
}

ReferencePlan plan_of_fixed_steps(const Scene& scene, const StudySettings& settings, const StepLimits& limits,
                                  StudyClock& clock) {
  RunPlan run;
  // The splitting method errs less and is of another family, but is of order 1 in damping.
  if (limits.is_damped()) {
    run.method = RungeKutta4{};
  } else {
    run.method = BlanesMoan{};
  }
  const double least = 1.5 * double(limits.stable_steps(run.method));
  run.steps = whole_ticks(rounded_steps(least));
  SampledRun trial(scene, settings, run, clock);
  trial.advance_to(short_horizon, clock.elapsed() + 0.1 * trial_share * settings.budget);
  const double steps_done = std::max(trial.time() / settings.horizon * double(run.steps), 1.0);
  const double seconds = reference_share * settings.budget;
  const double affordable = seconds * steps_done / std::max(trial.seconds(), 1e-9);
  const double worth = double(limits.steps_for_phase_error(1e-7 * settings.tolerance));
  run.steps = whole_ticks(rounded_steps(std::max(least, std::min(worth, affordable))));
  return {run, seconds};
}

}  // namespace hooke::study
