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
  const double longest = largest_stable_step(scene, method);
  return std::isinf(longest) ? std::nullopt : std::optional(StepLimit{longest});
}

}  // namespace hooke::viewer
