#include "study/method_ladder.h"

#include <algorithm>
#include <cmath>

#include "study/method_traits.h"

namespace hooke::study {
namespace {

constexpr double first_tolerance = 1e-2, last_tolerance = 1e-12;
constexpr unsigned most_coarser_runs =
    3;  // a bound is not so far off; unpinned, unforced scenes never diverge
constexpr unsigned fewest_stable_runs = 4;
constexpr double margin = 100.0;  // errors so much below the tolerance asked for say enough

}  // namespace

MethodLadder::MethodLadder(const Method& method, const StepLimits& limits, const StudySettings& settings,
                           std::uint64_t unit)
    : method_(solved_for_errors(method, settings.tolerance)),
      looks_(rounded_steps(double(limits.looks(method)), unit)),
      tolerance_(settings.tolerance),
      horizon_(settings.horizon),
      unit_(unit) {
  const std::uint64_t steps = limits.stable_steps(method);
  if (chooses_steps()) {
    add_tolerance(first_tolerance, double(steps) * traits_of(method).force_evaluations);
  } else {
    add_steps(rounded_steps(double(steps), unit));
  }
}

bool MethodLadder::chooses_steps() const {
  return !std::isnan(traits_of(method_).tolerance);
}

void MethodLadder::add_steps(std::uint64_t steps) {
  // What equations take is not known before the first run; for a dear one, that it is made too early costs
  // more.
  constexpr double evaluations_for_equations = 500.0;
  const double each =
      solves_equations(method_) ? evaluations_for_equations : traits_of(method_).force_evaluations;
  candidates_.push_back({{method_, steps}, double(steps) * each});
}

void MethodLadder::add_tolerance(double tolerance, double force_evaluations) {
  candidates_.push_back({{with_tolerance(method_, tolerance, horizon_), looks_}, force_evaluations});
}

void MethodLadder::add_coarser(std::uint64_t steps) {
  const std::uint64_t coarser = rounded_steps(0.5 * double(steps), unit_);
  if (coarser >= steps || coarser_runs_ == most_coarser_runs) return;
  ++coarser_runs_;
  add_steps(coarser);
}

Candidate MethodLadder::take(std::size_t number) {
  const Candidate candidate = candidates_[number];
  candidates_.erase(candidates_.begin() + std::ptrdiff_t(number));
  return candidate;
}

void MethodLadder::note_cost(const Candidate& candidate, const MeasuredRun& run) {
  // What a method that solves equations evaluates in a step is not known before: its time is taken for that
  // of the evaluations that the candidate was expected to have.
  const double expected = candidate.force_evaluations *
                          double(run.samples.empty() ? 0 : run.samples.back().sample.tick) / last_tick;
  const double evaluations =
      solves_equations(method_) && expected > 0.0 ? expected : double(run.force_evaluations);
  if (evaluations > 0.0) seconds_each_evaluation_ = run.seconds / evaluations;
}

void MethodLadder::add_result(const Candidate& candidate, const MeasuredRun& run, double error,
                              bool is_enough) {
  const bool stable = run.end == RunEnd::reached;
  note_cost(candidate, run);
  stable_runs_ += stable;
  const bool far_below = error < tolerance_ / margin && stable_runs_ >= fewest_stable_runs;
  const bool finer = !stable || !(is_enough || far_below);
  if (chooses_steps()) {
    const double next = 0.1 * traits_of(candidate.plan.method).tolerance;
    const double growth = std::pow(10.0, 1.0 / traits_of(method_).order);
    const double cost = stable ? growth * double(run.force_evaluations) : candidate.force_evaluations;
    if (finer && next > 0.5 * last_tolerance) add_tolerance(next, cost);
    return;
  }
  const std::uint64_t steps = candidate.plan.steps;
  if (stable && (coarsest_ == 0 || steps < coarsest_)) add_coarser(steps);
  if (finer && steps > finest_) add_steps(rounded_steps(2.0 * double(steps), unit_));
  coarsest_ = coarsest_ == 0 ? steps : std::min(coarsest_, steps);
  finest_ = std::max(finest_, steps);
}

}  // namespace hooke::study
