#include "scenes/hard/asked_method.h"

#include <cmath>

#include <hooke/stability.h>

namespace hooke::hard {

bool has_no_step_limit(const Method& method) {
  return std::visit([](const auto& one) { return std::isinf(one.oscillation_limit); }, method);
}

Settings asked_of(const Method& method, const Scene& scene, double step) {
  const bool bears_none = validate(scene).empty() && largest_stable_step(scene, method) == 0.0;
  return {.method = method,
          .step = step,
          .unstable_step = bears_none ? UnstableStep::refuse : UnstableStep::divide};
}

}  // namespace hooke::hard
