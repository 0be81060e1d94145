#include "effects/effect_functions.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/drag.cpp"
#include <hwy/foreach_target.h>

#include "effects/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

template <class Real>
HWY_INLINE void add(const Strip<Real>& strip, Real coefficient, StripForce<Real>& force) {
  for_each_vector(strip, [&](auto d, std::size_t lane) HWY_ATTR {
    const auto minus_c = hn::Set(d, -coefficient);
    add_product(d, minus_c, hn::LoadU(d, strip.vx + lane), force.x + lane);
    add_product(d, minus_c, hn::LoadU(d, strip.vy + lane), force.y + lane);
    add_product(d, minus_c, hn::LoadU(d, strip.vz + lane), force.z + lane);
  });
}

}  // namespace

void drag_float(const Strip<float>& strip, float coefficient, StripForce<float>& force) {
  add(strip, coefficient, force);
}

void drag_double(const Strip<double>& strip, double coefficient, StripForce<double>& force) {
  add(strip, coefficient, force);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {
namespace {

HWY_EXPORT(drag_float);
HWY_EXPORT(drag_double);

/// Subtracts c v for each lane.
void add_drag(const Strip<float>& strip, float coefficient, StripForce<float>& force) {
  HWY_DYNAMIC_DISPATCH(drag_float)(strip, coefficient, force);
}

void add_drag(const Strip<double>& strip, double coefficient, StripForce<double>& force) {
  HWY_DYNAMIC_DISPATCH(drag_double)(strip, coefficient, force);
}

template <class Real>
class DragForce final : public CompiledEffect<Real> {
 public:
  explicit DragForce(const Drag& drag) : c_(Real(drag.coefficient)) {}

  void add_force(const Strip<Real>& strip, double, StripForce<Real>& force) const override {
    add_drag(strip, c_, force);
  }

  void add_derivative(const Strip<Real>& strip, double, const DerivativeWeights<Real>& weights,
                      StripBlocks<Real>& blocks) const override {
    for (Real* const diagonal : {blocks.xx, blocks.yy, blocks.zz}) {
      for (std::size_t lane = 0; lane < strip.lanes; ++lane) diagonal[lane] += weights.damping * c_;
    }
  }

  unsigned parts() const override { return has_force | has_own_derivative; }

  Stage stage() const override { return {std::string(Drag::name), {}, {"velocity"}, {"force"}, 0}; }

 private:
  Real c_;  ///< [N s/m]
};

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const Drag& drag, const EffectContext<Real>&) {
  return std::make_unique<DragForce<Real>>(drag);
}

template EffectPointer<float> compile_effect(const Drag&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const Drag&, const EffectContext<double>&);

void check_effect(const Drag& drag, const Scene&, const ElementChecks& checks) {
  checks.not_negative("coefficient", drag.coefficient, "N s/m");
}

void add_bounds(const Drag& drag, const Scene&, HeldParticles& held) {
  held.add_to_each(0.0, drag.coefficient);
}

}  // namespace hooke
#endif
