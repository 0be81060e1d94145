#include "effects/effect_functions.h"
#include "effects/masses_to_pull.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/gravity.cpp"
#include <hwy/foreach_target.h>

#include "effects/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

template <class Real>
HWY_INLINE void add(const Strip<Real>& strip, const BlockRows<Real>& mass, const Real* g,
                    StripForce<Real>& force) {
  for_each_vector(strip, [&](auto d, std::size_t lane) HWY_ATTR {
    const auto m = hn::Load(d, mass.block((strip.first + lane) / block_size) + lane % block_size);
    add_product(d, m, hn::Set(d, g[0]), force.x + lane);
    add_product(d, m, hn::Set(d, g[1]), force.y + lane);
    add_product(d, m, hn::Set(d, g[2]), force.z + lane);
  });
}

}  // namespace

void weight_float(const Strip<float>& strip, const BlockRows<float>& mass, const float* g,
                  StripForce<float>& force) {
  add(strip, mass, g, force);
}

void weight_double(const Strip<double>& strip, const BlockRows<double>& mass, const double* g,
                   StripForce<double>& force) {
  add(strip, mass, g, force);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {
namespace {

HWY_EXPORT(weight_float);
HWY_EXPORT(weight_double);

/// Adds m g for each lane.
void add_weight(const Strip<float>& strip, const BlockRows<float>& mass, const float* g,
                StripForce<float>& force) {
  HWY_DYNAMIC_DISPATCH(weight_float)(strip, mass, g, force);
}

void add_weight(const Strip<double>& strip, const BlockRows<double>& mass, const double* g,
                StripForce<double>& force) {
  HWY_DYNAMIC_DISPATCH(weight_double)(strip, mass, g, force);
}

template <class Real>
class GravityForce final : public CompiledEffect<Real> {
 public:
  GravityForce(const Gravity& gravity, const EffectContext<Real>& context)
      : g_(gravity.acceleration.cast<Real>()), mass_(masses_to_pull(context.scene, context.model)) {}

  void add_force(const Strip<Real>& strip, double, StripForce<Real>& force) const override {
    add_weight(strip, mass_, g_.data(), force);
  }

  double energy(const Strip<Real>& strip) const override {
    double sum = 0.0;
    for (std::size_t lane = 0; lane < strip.particles; ++lane) {
      const Vec3 position(strip.x[lane], strip.y[lane], strip.z[lane]);
      sum -= double(mass_[strip.first + lane]) * g_.template cast<double>().dot(position);
    }
    return sum;
  }

  Stage stage() const override {
    return {std::string(Gravity::name), {}, {"mass"}, {"force"}, mass_.bytes()};
  }

 private:
  Eigen::Matrix<Real, 3, 1> g_;
  BlockRows<Real> mass_;  ///< [kg], 0 where pinned
};

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const Gravity& gravity, const EffectContext<Real>& context) {
  return std::make_unique<GravityForce<Real>>(gravity, context);
}

template EffectPointer<float> compile_effect(const Gravity&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const Gravity&, const EffectContext<double>&);

void check_effect(const Gravity& gravity, const Scene&, const ElementChecks& checks) {
  checks.finite("acceleration", gravity.acceleration, "m/s^2");
}

void add_bounds(const Gravity&, const Scene&, HeldParticles&) {}

}  // namespace hooke
#endif
