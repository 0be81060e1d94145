#include "effects/effect_functions.h"
#include "effects/field_at.h"
#include "effects/field_checks.h"

namespace hooke {
namespace {

template <class Real>
class ParticleWindForce final : public CompiledEffect<Real> {
 public:
  explicit ParticleWindForce(const ParticleWind& wind) : wind_(wind), c_(Real(wind.coefficient)) {}

  /// Wind that drags nothing has no part in a step.
  unsigned parts() const override { return c_ > Real(0) ? has_force | has_own_derivative : 0; }

  void add_force(const Strip<Real>& strip, double time, StripForce<Real>& force) const override {
    if (const auto* uniform = std::get_if<UniformField>(&wind_.velocity)) {
      const Vec3 air = factor_at(wind_.envelope, time) * uniform->value;
      add(strip.particles, Real(air.x()), strip.vx, force.x);
      add(strip.particles, Real(air.y()), strip.vy, force.y);
      add(strip.particles, Real(air.z()), strip.vz, force.z);
      return;
    }
    with_field_at(wind_.velocity, wind_.envelope, time, [&](const auto& air) {
      for (std::size_t lane = 0; lane < strip.particles; ++lane) {
        const Vec3 u = air(Vec3(strip.x[lane], strip.y[lane], strip.z[lane]));
        force.x[lane] += c_ * (Real(u.x()) - strip.vx[lane]);
        force.y[lane] += c_ * (Real(u.y()) - strip.vy[lane]);
        force.z[lane] += c_ * (Real(u.z()) - strip.vz[lane]);
      }
    });
  }

  void add_derivative(const Strip<Real>& strip, double, const DerivativeWeights<Real>& weights,
                      StripBlocks<Real>& blocks) const override {
    for (Real* const diagonal : {blocks.xx, blocks.yy, blocks.zz}) {
      for (std::size_t lane = 0; lane < strip.lanes; ++lane) diagonal[lane] += weights.damping * c_;
    }
  }

  void disturb(double from, double to, Disturbances& disturbed) const override {
    if (c_ > Real(0) && changes(wind_.velocity, wind_.envelope, from, to)) disturbed.all();
  }

  bool calls_user() const override { return std::holds_alternative<CallbackField>(wind_.velocity); }

  Stage stage() const override {
    return {std::string(ParticleWind::name), {}, {"position", "velocity", "time"}, {"force"}, 0};
  }

 private:
  void add(std::size_t particles, Real air, const Real* v, Real* force) const {
    for (std::size_t lane = 0; lane < particles; ++lane) force[lane] += c_ * (air - v[lane]);
  }

  ParticleWind wind_;
  Real c_;  ///< [N s/m]
};

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const ParticleWind& wind, const EffectContext<Real>&) {
  return std::make_unique<ParticleWindForce<Real>>(wind);
}

template EffectPointer<float> compile_effect(const ParticleWind&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const ParticleWind&, const EffectContext<double>&);

void check_effect(const ParticleWind& wind, const Scene&, const ElementChecks& checks) {
  checks.not_negative("coefficient", wind.coefficient, "N s/m");
  check_shape("velocity", wind.velocity, "m/s", checks);
  check_envelope(wind.envelope, checks);
}

void add_bounds(const ParticleWind& wind, const Scene&, HeldParticles& held) {
  held.add_to_each(0.0, wind.coefficient);
}

}  // namespace hooke
