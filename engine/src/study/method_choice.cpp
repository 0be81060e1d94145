#include "study/method_choice.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "study/method_traits.h"

namespace hooke::study {

MethodChoice choice_of(const RunPlan& plan, const StudySettings& settings) {
  const MethodTraits traits = traits_of(plan.method);
  const double step = settings.horizon / double(plan.steps);
  return {std::string(traits.name), std::isnan(traits.tolerance) ? step : not_measured, traits.tolerance};
}

MethodChoice choice_of(const RunPlan& plan, const SampledRun& run, const StudySettings& settings) {
  MethodChoice choice = choice_of(plan, settings);
  if (std::isnan(choice.tolerance)) return choice;
  const double steps = double(run.force_evaluations()) / traits_of(plan.method).force_evaluations;
  choice.step = run.time() / std::max(1.0, steps);
  return choice;
}

std::string short_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

}  // namespace hooke::study

namespace hooke {

std::string to_string(const MethodChoice& choice) {
  if (!std::isnan(choice.tolerance))
    return choice.method + ", tolerance " + study::short_text(choice.tolerance);
  if (choice.step < 1e-3) return choice.method + ", step " + study::short_text(1e6 * choice.step) + " us";
  if (choice.step < 1.0) return choice.method + ", step " + study::short_text(1e3 * choice.step) + " ms";
  return choice.method + ", step " + study::short_text(choice.step) + " s";
}

}  // namespace hooke
