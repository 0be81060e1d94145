#include <algorithm>
#include <cmath>

#include "effects/effect_functions.h"
#include "effects/enclosed_gas.h"
#include "scene/chosen_triangles.h"
#include "scene/closed_surface.h"

namespace hooke {
namespace {

/// Gas that is pressed together further than this share of its volume gets no stiffer: an inside that is
/// turned out has no volume.
constexpr double least_share = 1e-3;

/// Boyle's and Mariotte's law, or Poisson's with an exponent other than 1. The energy is counted from the
/// start.
PressureLaw gas(const Pressure& effect, double start, double volume) {
  const double inside = effect.ambient + effect.overpressure;
  const double share = std::max(volume / start, least_share);
  const double pressure = inside * std::pow(share, -effect.exponent);
  const double slope = volume > least_share * start ? -effect.exponent * pressure / (share * start) : 0.0;
  const double work =
      effect.exponent == 1.0
          ? inside * start * std::log(share)
          : inside * start * (std::pow(share, 1.0 - effect.exponent) - 1.0) / (1.0 - effect.exponent);
  const double beyond = pressure * (volume - share * start);  // what was pressed further
  return {pressure - effect.ambient, slope, effect.ambient * (volume - start) - work - beyond};
}

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const Pressure& effect, const EffectContext<Real>& context) {
  const std::vector<Triangle> triangles = chosen_triangles(context.scene, effect.triangles);
  const double start = enclosed_volume(context.scene.particles.position, triangles);
  return compile_enclosed_gas<Real>(
      Pressure::name, triangles,
      [=](double volume) {
        return gas({effect.overpressure, effect.ambient, effect.exponent, {}}, start, volume);
      },
      context);
}

template EffectPointer<float> compile_effect(const Pressure&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const Pressure&, const EffectContext<double>&);

void check_effect(const Pressure& effect, const Scene& scene, const ElementChecks& checks) {
  checks.finite("overpressure", effect.overpressure, "Pa");
  checks.not_negative("ambient", effect.ambient, "Pa");
  checks.not_negative("exponent", effect.exponent, "");
  if (effect.ambient + effect.overpressure < 0.0)
    checks.add("ambient and overpressure are together less than nothing",
               "give an overpressure of at least minus the ambient pressure");
  check_closed_surface(scene, effect.triangles, checks);
}

void add_bounds(const Pressure& effect, const Scene& scene, HeldParticles& held) {
  const std::vector<Triangle> triangles = chosen_triangles(scene, effect.triangles);
  const double start = enclosed_volume(scene.particles.position, triangles);
  add_bounds_of_gas(triangles, gas(effect, start, start), scene, held);
}

}  // namespace hooke
