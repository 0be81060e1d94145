#include "effects/effect_functions.h"

namespace hooke {
namespace {

template <class Real>
class CompiledParticleContact final : public CompiledEffect<Real> {
 public:
  unsigned parts() const override { return 0; }
  Stage stage() const override { return {std::string(ParticleContact::name), {}, {}, {}, 0}; }
};

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const ParticleContact&, const EffectContext<Real>&) {
  return std::make_unique<CompiledParticleContact<Real>>();
}

template EffectPointer<float> compile_effect(const ParticleContact&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const ParticleContact&, const EffectContext<double>&);

void check_effect(const ParticleContact&, const Scene&, const ElementChecks&) {}

void add_bounds(const ParticleContact&, const Scene&, HeldParticles&) {}

}  // namespace hooke
