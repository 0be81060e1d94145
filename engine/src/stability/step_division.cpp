#include "stability/step_division.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <hooke/stability.h>

#include "scene/element_checks.h"
#include "scene/number_text.h"

namespace hooke {
namespace {

/// More would hardly be meant: each step would take as long as a simulation.
constexpr double most_substeps = 1e5;

/// Those that the settings' step is taken in if it is divided; more than can be where that is refused.
double substeps_if_divided(const Settings& settings, double longest) {
  if (longest == 0.0 && !bears_oscillations(settings.method)) return 1.0;
  return needed_substeps(settings.step, longest);
}

}  // namespace

double needed_substeps(double step, double longest) {
  return std::max(1.0, std::ceil(step / (division_margin * longest)));
}

bool bears_oscillations(const Method& method) {
  return std::visit([](const auto& one) { return one.oscillation_limit > 0.0; }, method);
}

std::uint64_t substeps_of(const StepBounds& bounds, const Settings& settings) {
  if (settings.unstable_step != UnstableStep::divide) return 1;
  return std::uint64_t(std::min(substeps_if_divided(settings, bounds.longest_step), most_substeps));
}

OnTrouble on_trouble(const Settings& settings) {
  const bool as_it_is = settings.unstable_step == UnstableStep::take;
  return settings.on_trouble.value_or(as_it_is ? OnTrouble::ignore : OnTrouble::stop);
}

bool may_halve(const Settings& settings) {
  return settings.decide_on_trouble || on_trouble(settings) == OnTrouble::halve;
}

void check_stability(std::vector<Fault>& faults, const StepBounds& bounds, const Settings& settings) {
  if (settings.unstable_step == UnstableStep::take) return;
  const double longest = bounds.longest_step;
  const double needed = substeps_if_divided(settings, longest);
  const bool refused = settings.unstable_step == UnstableStep::refuse && settings.step > longest;
  if (!refused && needed <= most_substeps) return;
  const std::string method(to_string(settings.method));
  if (longest == 0.0 && !bears_oscillations(settings.method)) {
    ElementChecks(faults, "settings")
        .add("method is " + method + ", which lets every undamped oscillation grow",
             "use symplectic_euler, or unstable_step \"take\" to see it");
    return;
  }
  ElementChecks(faults, "settings")
      .add("step is " + to_text(settings.step) + " s, and " + method + " surely bears only " +
               rounded_down(longest) + " s in this scene",
           refused ? "give a shorter step, or unstable_step \"divide\""
                   : "give a shorter step, softer springs or heavier particles");
}

}  // namespace hooke
