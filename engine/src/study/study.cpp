// Start here: a study of accuracy is two references, a sweep over all methods, and what is read from them.

#include <hooke/study.h>

#include "scene/element_checks.h"
#include "scene/number_text.h"
#include "study/accuracy_rows.h"
#include "study/answer.h"
#include "study/reference_solution.h"
#include "study/step_limits.h"
#include "study/sweep.h"

namespace hooke {
namespace {

using namespace study;

void throw_if_unusable(const Scene& scene, const StudySettings& settings) {
  std::vector<Fault> faults = validate(scene);
  const ElementChecks checks(faults, "study");
  checks.positive("horizon", settings.horizon, "s");
  checks.positive("budget", settings.budget, "s");
  if (!(settings.tolerance > 0.0 && settings.tolerance < 1.0))
    checks.add("tolerance is " + to_text(settings.tolerance), "give a share of the scene's size > 0 and < 1");
  if (faults.empty() && scene.pins.size() >= scene.particles.size())
    ElementChecks(faults, "scene").add("has no particle that is free to move", "add one, or remove a pin");
  throw_if_any(std::move(faults));
}

StudySettings with_executor(StudySettings settings) {
  if (!settings.executor) settings.executor = make_tbb_executor(settings.threads);
  return settings;
}

/// The last output up to which the references agree so well that errors far below the tolerance can be told.
unsigned clear_tick(const ReferenceSolution& reference, double tolerance) {
  constexpr double far_below = 1e-3;
  unsigned clear = 0;
  for (unsigned tick = 1; tick <= reference.trusted; ++tick) {
    if (is_output(tick) && reference.smallest_error(tick) <= far_below * tolerance) clear = tick;
  }
  return clear;
}

/// The two horizons [ticks] at which runs are compared: as far as the reference is trusted, and a tenth of
/// that. Where trust ends before the study's horizon, errors are hard to tell near its end, and the shorter
/// one is where they still can be.
std::vector<unsigned> horizons_of(const ReferenceSolution& reference, double tolerance) {
  const unsigned trusted = reference.trusted;
  if (trusted == 0) return {};
  const unsigned clear = trusted < last_tick ? clear_tick(reference, tolerance) : 0;
  const unsigned tenth = trusted / 10;  // all ticks up to the short horizon are outputs
  const unsigned shorter = clear > 0 && clear < trusted ? clear : tenth;
  if (shorter == 0) return {trusted};
  return {shorter, trusted};
}

AccuracyStudy described(const Scene& scene, const StudySettings& settings, const StepLimits& limits,
                        const ReferenceSolution& reference) {
  AccuracyStudy result;
  result.scene = scene.name;
  result.particles = scene.particles.size();
  result.springs = scene.springs.size();
  result.threads = settings.executor->threads();
  result.tolerance = settings.tolerance;
  result.horizon = settings.horizon;
  result.budget = settings.budget;
  result.scene_size = reference.scene_size;
  result.energy_scale = reference.energy_scale;
  result.momentum_scale = reference.momentum_scale;
  result.highest_frequency = limits.highest_frequency();
  result.reference = reference.report;
  return result;
}

}  // namespace

AccuracyStudy study_accuracy(const Scene& scene, const StudySettings& given) {
  throw_if_unusable(scene, given);
  const StudySettings settings = with_executor(given);
  StudyClock clock(settings);
  const StepLimits limits(scene, settings.horizon);
  const ReferenceSolution reference = make_reference(scene, settings, limits, clock);
  const std::vector<unsigned> horizons = horizons_of(reference, settings.tolerance);
  AccuracyStudy result = described(scene, settings, limits, reference);
  for (const unsigned tick : horizons) {
    result.horizons.push_back(settings.horizon * tick / last_tick);
    result.smallest_errors.push_back(reference.smallest_error(tick));
  }
  Sweep sweep = sweep_methods(scene, settings, limits, reference, horizons, clock);
  result.runs = accuracy_rows(sweep.runs, reference, horizons, settings);
  result.energies = energy_histories(sweep, settings);
  result.long_runs = long_runs(sweep, reference);
  result.omitted = std::move(sweep.omitted);
  result.answer = answer_of(result);
  result.stopped = sweep.stopped;
  result.seconds = clock.elapsed();
  return result;
}

}  // namespace hooke
