#include <hooke/simulation.h>

#include "scene/element_checks.h"
#include "stability/step_division.h"

namespace hooke {
namespace {

template <class FixedStep>
void check_method(std::vector<Fault>&, const FixedStep&) {}

void check_method(std::vector<Fault>& faults, const DormandPrince& method) {
  const ElementChecks checks(faults, "method (dormand_prince)");
  checks.positive("tolerance", method.tolerance, "");
  checks.not_negative("position_tolerance", method.position_tolerance, "m");
  checks.not_negative("velocity_tolerance", method.velocity_tolerance, "m/s");
  checks.positive("smallest_step", method.smallest_step, "s");
}

}  // namespace

std::vector<Fault> validate(const Scene& scene, const Settings& settings) {
  std::vector<Fault> faults = validate(scene);
  const ElementChecks checks(faults, "settings");
  checks.positive("step", settings.step, "s");
  checks.at_least("max_steps_per_advance", settings.max_steps_per_advance, 1);
  std::visit([&](const auto& method) { check_method(faults, method); }, settings.method);
  if (faults.empty()) check_stability(faults, scene, settings);
  return faults;
}

}  // namespace hooke
