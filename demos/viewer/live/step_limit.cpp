#include "viewer/live/step_limit.h"

#include <cmath>
#include <variant>

#include <hooke/stability.h>

namespace hooke::viewer {

bool chooses_steps(const Method& method) {
  return std::visit(
      [](const auto& one) {
        return requires {
          one.tolerance;
        };
      },
      method);
}

std::optional<StepLimit> step_limit(const Scene& scene, const Method& method) {
  if (chooses_steps(method)) return std::nullopt;
  const double frequency = highest_frequency(scene), damping = highest_damping_rate(scene);
  if (frequency == 0.0 && damping == 0.0) return std::nullopt;
  const double limit = std::visit([](const auto& one) { return one.oscillation_limit; }, method);
  if (limit == 0.0) return StepLimit{};
  // The equation solved for 1 / h, so that no case is apart where the frequency is 0.
  return StepLimit{limit * limit / (damping + std::hypot(damping, frequency * limit))};
}

}  // namespace hooke::viewer
