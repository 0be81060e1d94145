#include <algorithm>
#include <string>

#include "effects/effect_functions.h"
#include "effects/in_no_step.h"

namespace hooke {

/// Simulation does it, between steps (simulation_sleep.cpp).
template <class Real>
EffectPointer<Real> compile_effect(const Sleep&, const EffectContext<Real>&) {
  return std::make_unique<InNoStep<Real>>();
}

template EffectPointer<float> compile_effect(const Sleep&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const Sleep&, const EffectContext<double>&);

void check_effect(const Sleep& sleep, const Scene& scene, const ElementChecks& checks) {
  checks.positive("speed", sleep.speed, "m/s");
  checks.not_negative("time", sleep.time, "s");
  const auto is_sleep = [](const Effect& effect) { return std::holds_alternative<Sleep>(effect); };
  const auto named = std::ranges::count_if(scene.effects, is_sleep);
  if (named > 1)
    checks.add("sleep is named " + std::to_string(named) + " times, so that nobody could say which counts",
               "name it once");
}

/// It takes no shorter steps.
void add_bounds(const Sleep&, const Scene&, HeldParticles&) {}

}  // namespace hooke
