#include <hooke/simulation.h>

#include "scene/element_checks.h"

namespace hooke {

std::vector<Fault> validate(const Scene& scene, const Settings& settings) {
  std::vector<Fault> faults = validate(scene);
  const ElementChecks checks(faults, "settings");
  checks.positive("step", settings.step, "s");
  checks.at_least("max_steps_per_advance", settings.max_steps_per_advance, 1);
  return faults;
}

}  // namespace hooke
