#include <algorithm>
#include <string>

#include "effects/axial_springs.h"
#include "effects/effect_functions.h"
#include "effects/named_springs.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/cables.cpp"
#include <hwy/foreach_target.h>

#include "kernels/axial-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

/// Coefficients: 1, k, l0, c.
struct Law {
  static constexpr std::size_t corners = 2, coefficients = 4;
  static constexpr bool velocities = true;

  template <std::size_t role, class D, class Element>
  HWY_INLINE auto force(D d, const Element& e) const {
    const auto axis = axis_of(d, e);
    const auto stretch = hn::Sub(axis.length, e.c[2]);
    const auto tension = hn::MulAdd(e.c[3], dot(axis.along, e.v[0] - e.v[1]), hn::Mul(e.c[1], stretch));
    const auto taut = hn::Gt(stretch, hn::Zero(d));
    return pull<role>(d, hn::IfThenElseZero(taut, hn::Max(tension, hn::Zero(d))), axis);
  }
};

/// The derivative of what is taut times a direction; none of it is negative.
template <class Real>
struct ProductLaw {
  static constexpr std::size_t corners = 2, coefficients = 4;
  static constexpr bool velocities = true;
  DerivativeWeights<Real> weights;

  template <std::size_t role, class D, class Element>
  HWY_INLINE auto force(D d, const Element& e) const {
    const auto axis = axis_of(d, e);
    const auto stretch = hn::Sub(axis.length, e.c[2]);
    const auto taut = hn::Gt(stretch, hn::Zero(d));
    const auto stiffness = hn::IfThenElseZero(taut, hn::Mul(hn::Set(d, weights.stiffness), e.c[1]));
    const auto damping = hn::IfThenElseZero(taut, hn::Mul(hn::Set(d, weights.damping), e.c[3]));
    const auto across = hn::Mul(stiffness, hn::Mul(stretch, axis.inverse_length));
    return axial_product<role>(d, hn::Add(stiffness, damping), across, axis, e);
  }
};

}  // namespace

void pull_float(const ElementSlots<float>& slots, const Strip<float>& strip, StripForce<float>& force) {
  add_element_forces(slots, strip, Law{}, force);
}

void pull_double(const ElementSlots<double>& slots, const Strip<double>& strip, StripForce<double>& force) {
  add_element_forces(slots, strip, Law{}, force);
}

void multiply_pull_float(const ElementSlots<float>& slots, const Strip<float>& search,
                         const DerivativeWeights<float>& weights, StripForce<float>& product) {
  add_element_forces(slots, search, ProductLaw<float>{weights}, product);
}

void multiply_pull_double(const ElementSlots<double>& slots, const Strip<double>& search,
                          const DerivativeWeights<double>& weights, StripForce<double>& product) {
  add_element_forces(slots, search, ProductLaw<double>{weights}, product);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {
namespace {

HWY_EXPORT(pull_float);
HWY_EXPORT(pull_double);
HWY_EXPORT(multiply_pull_float);
HWY_EXPORT(multiply_pull_double);

void add_pull(const ElementSlots<float>& slots, const Strip<float>& strip, StripForce<float>& force) {
  HWY_DYNAMIC_DISPATCH(pull_float)(slots, strip, force);
}

void add_pull(const ElementSlots<double>& slots, const Strip<double>& strip, StripForce<double>& force) {
  HWY_DYNAMIC_DISPATCH(pull_double)(slots, strip, force);
}

void multiply_pull(const ElementSlots<float>& slots, const Strip<float>& search,
                   const DerivativeWeights<float>& weights, StripForce<float>& product) {
  HWY_DYNAMIC_DISPATCH(multiply_pull_float)(slots, search, weights, product);
}

void multiply_pull(const ElementSlots<double>& slots, const Strip<double>& search,
                   const DerivativeWeights<double>& weights, StripForce<double>& product) {
  HWY_DYNAMIC_DISPATCH(multiply_pull_double)(slots, search, weights, product);
}

Elements elements_of(const Cables& cables, const Springs& springs) {
  Elements elements{2, 4};
  for (const Index s : cables.springs) {
    const double k = springs.stiffness[s], c = springs.damping_of(s);
    if (k == 0.0 && c == 0.0) continue;
    elements.add({springs.first[s], springs.second[s]}, {1.0, k, springs.rest_length[s], c});
  }
  return elements;
}

template <class Real>
class CableForce final : public CompiledEffect<Real> {
 public:
  CableForce(const Cables& cables, const EffectContext<Real>& context)
      : slots_(make_element_slots<Real>(elements_of(cables, context.scene.springs), context.model.order)) {}

  unsigned parts() const override {
    return slots_.slots.empty() ? 0 : has_force | is_coupled | has_own_derivative;
  }

  void add_force(const Strip<Real>& strip, double, StripForce<Real>& force) const override {
    add_pull(slots_, strip, force);
  }

  void add_derivative(const Strip<Real>& strip, double, const DerivativeWeights<Real>& weights,
                      StripBlocks<Real>& blocks) const override {
    const auto derivative_of = [&](const ElementCorner<Real>& cable, double length) -> AxialDerivative {
      const double k = cable.coefficients[1], rest = cable.coefficients[2], c = cable.coefficients[3];
      if (length <= rest) return {};
      const double stiffness = double(weights.stiffness) * k;
      return {stiffness + double(weights.damping) * c, stiffness * (1.0 - rest / length)};
    };
    add_axial_blocks(slots_, strip, derivative_of, blocks);
  }

  /// (a - b)^2 <= 2 (a^2 + b^2).
  double coupling() const override { return 2.0; }

  void add_product(const Strip<Real>& search, const DerivativeWeights<Real>& weights, Curvature,
                   StripForce<Real>& product) const override {
    multiply_pull(slots_, search, weights, product);
  }

  std::size_t reach() const override { return slots_.reach; }

  double energy(const Strip<Real>& strip) const override {
    return axial_energy(slots_, strip, [](const ElementCorner<Real>& cable, double length) {
      const double stretch = std::max(length - cable.coefficients[2], 0.0);
      return 0.5 * cable.coefficients[1] * stretch * stretch;
    });
  }

  Stage stage() const override {
    return {std::string(Cables::name), {}, {"position", "velocity"}, {"force"}, slots_.bytes()};
  }

 private:
  ElementSlots<Real> slots_;
};

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const Cables& cables, const EffectContext<Real>& context) {
  return std::make_unique<CableForce<Real>>(cables, context);
}

template EffectPointer<float> compile_effect(const Cables&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const Cables&, const EffectContext<double>&);

void check_effect(const Cables& cables, const Scene& scene, const ElementChecks& checks) {
  check_spring_list(cables.springs, scene, checks);
  check_only_law(cables, scene, checks);
}

/// The bounds of springs hold for them too.
void add_bounds(const Cables&, const Scene&, HeldParticles&) {}

}  // namespace hooke
#endif
