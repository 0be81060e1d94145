#include "effects/effect_functions.h"
#include "effects/enclosed_gas.h"
#include "scene/chosen_triangles.h"
#include "scene/closed_surface.h"

namespace hooke {
namespace {

PressureLaw elastic(double bulk_modulus, double at_rest, double volume) {
  const double change = volume - at_rest;
  return {-bulk_modulus * change / at_rest, -bulk_modulus / at_rest,
          0.5 * bulk_modulus * change * change / at_rest};
}

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const Volume& effect, const EffectContext<Real>& context) {
  const std::vector<Triangle> triangles = chosen_triangles(context.scene, effect.triangles);
  const double at_rest = effect.ratio * enclosed_volume(context.scene.particles.position, triangles);
  return compile_enclosed_gas<Real>(
      Volume::name, triangles,
      [=, modulus = effect.bulk_modulus](double volume) { return elastic(modulus, at_rest, volume); },
      context);
}

template EffectPointer<float> compile_effect(const Volume&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const Volume&, const EffectContext<double>&);

void check_effect(const Volume& effect, const Scene& scene, const ElementChecks& checks) {
  checks.not_negative("bulk_modulus", effect.bulk_modulus, "Pa");
  checks.positive("ratio", effect.ratio, "");
  check_closed_surface(scene, effect.triangles, checks);
}

void add_bounds(const Volume& effect, const Scene& scene, HeldParticles& held) {
  const std::vector<Triangle> triangles = chosen_triangles(scene, effect.triangles);
  const double volume = enclosed_volume(scene.particles.position, triangles);
  add_bounds_of_gas(triangles, elastic(effect.bulk_modulus, effect.ratio * volume, volume), scene, held);
}

}  // namespace hooke
