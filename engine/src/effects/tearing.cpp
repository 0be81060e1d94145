#include "effects/effect_functions.h"

namespace hooke {
namespace {

template <class Real>
class CompiledTearing final : public CompiledEffect<Real> {
 public:
  unsigned parts() const override { return 0; }
  Stage stage() const override { return {std::string(Tearing::name), {}, {}, {}, 0}; }
};

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const Tearing&, const EffectContext<Real>&) {
  return std::make_unique<CompiledTearing<Real>>();
}

template EffectPointer<float> compile_effect(const Tearing&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const Tearing&, const EffectContext<double>&);

void check_effect(const Tearing&, const Scene&, const ElementChecks&) {}

void add_bounds(const Tearing&, const Scene&, HeldParticles&) {}

}  // namespace hooke
