#include "effects/effect_functions.h"

namespace hooke {
namespace {

/// Simulation does it, between steps (simulation_sleep.cpp).
template <class Real>
class BetweenSteps final : public CompiledEffect<Real> {
 public:
  unsigned parts() const override { return 0; }
  Stage stage() const override { return {}; }
};

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const Sleep&, const EffectContext<Real>&) {
  return std::make_unique<BetweenSteps<Real>>();
}

template EffectPointer<float> compile_effect(const Sleep&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const Sleep&, const EffectContext<double>&);

void check_effect(const Sleep& sleep, const Scene&, const ElementChecks& checks) {
  checks.positive("speed", sleep.speed, "m/s");
  checks.not_negative("time", sleep.time, "s");
}

/// It takes no shorter steps.
void add_bounds(const Sleep&, const Scene&, HeldParticles&) {}

}  // namespace hooke
