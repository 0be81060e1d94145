#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "effects/axial_springs.h"
#include "effects/effect_functions.h"
#include "effects/named_springs.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/stiffening_springs.cpp"
#include <hwy/foreach_target.h>

#include "kernels/axial-inl.h"

#ifndef HOOKE_STIFFENING
#define HOOKE_STIFFENING
namespace hooke {

/// What the strain's square and cube count for, in the precision of the run.
template <class Real>
struct Stiffening {
  Real quadratic, cubic;
};

}  // namespace hooke
#endif

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

/// The strain of a spring with the coefficients k l0, 1 / l0.
template <class D, class V, class Element>
HWY_INLINE V strain_of(D d, const Axis<V>& axis, const Element& e) {
  return hn::MulSub(axis.length, e.c[1], hn::Set(d, hn::TFromD<D>(1)));
}

/// T = k l0 (q |s| + c s^2) s.
template <class D, class V, class Real, class Element>
HWY_INLINE V tension_of(D d, V strain, const Stiffening<Real>& curve, const Element& e) {
  const V size = hn::Abs(strain);
  const V slope = hn::MulAdd(hn::Set(d, curve.cubic), size, hn::Set(d, curve.quadratic));
  return hn::Mul(hn::Mul(e.c[0], strain), hn::Mul(slope, size));
}

template <class Real>
struct Law {
  static constexpr std::size_t corners = 2, coefficients = 2;
  static constexpr bool velocities = false;
  Stiffening<Real> curve;

  template <std::size_t role, class D, class Element>
  HWY_INLINE auto force(D d, const Element& e) const {
    const auto axis = axis_of(d, e);
    return pull<role>(d, tension_of(d, strain_of(d, axis, e), curve, e), axis);
  }
};

template <class Real>
struct ProductLaw {
  static constexpr std::size_t corners = 2, coefficients = 2;
  static constexpr bool velocities = true;
  Stiffening<Real> curve;
  Real weight, least_across;  ///< 0 where what is pressed must not buckle, else the lowest number

  template <std::size_t role, class D, class Element>
  HWY_INLINE auto force(D d, const Element& e) const {
    const auto axis = axis_of(d, e);
    const auto strain = strain_of(d, axis, e), size = hn::Abs(strain);
    const auto slope =
        hn::MulAdd(hn::Set(d, Real(3) * curve.cubic), size, hn::Set(d, Real(2) * curve.quadratic));
    const auto w = hn::Set(d, weight);
    const auto along = hn::Mul(hn::Mul(w, hn::Mul(e.c[0], e.c[1])), hn::Mul(slope, size));
    const auto across = hn::Mul(w, hn::Mul(tension_of(d, strain, curve, e), axis.inverse_length));
    return axial_product<role>(d, along, hn::Max(across, hn::Set(d, least_across)), axis, e);
  }
};

}  // namespace

void stiffen_float(const ElementSlots<float>& slots, const Strip<float>& strip,
                   const Stiffening<float>& curve, StripForce<float>& force) {
  add_element_forces(slots, strip, Law<float>{curve}, force);
}

void stiffen_double(const ElementSlots<double>& slots, const Strip<double>& strip,
                    const Stiffening<double>& curve, StripForce<double>& force) {
  add_element_forces(slots, strip, Law<double>{curve}, force);
}

void multiply_stiffness_float(const ElementSlots<float>& slots, const Strip<float>& search,
                              const Stiffening<float>& curve, float weight, float least_across,
                              StripForce<float>& product) {
  add_element_forces(slots, search, ProductLaw<float>{curve, weight, least_across}, product);
}

void multiply_stiffness_double(const ElementSlots<double>& slots, const Strip<double>& search,
                               const Stiffening<double>& curve, double weight, double least_across,
                               StripForce<double>& product) {
  add_element_forces(slots, search, ProductLaw<double>{curve, weight, least_across}, product);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {
namespace {

HWY_EXPORT(stiffen_float);
HWY_EXPORT(stiffen_double);
HWY_EXPORT(multiply_stiffness_float);
HWY_EXPORT(multiply_stiffness_double);

void stiffen(const ElementSlots<float>& slots, const Strip<float>& strip, const Stiffening<float>& curve,
             StripForce<float>& force) {
  HWY_DYNAMIC_DISPATCH(stiffen_float)(slots, strip, curve, force);
}

void stiffen(const ElementSlots<double>& slots, const Strip<double>& strip, const Stiffening<double>& curve,
             StripForce<double>& force) {
  HWY_DYNAMIC_DISPATCH(stiffen_double)(slots, strip, curve, force);
}

void multiply_stiffness(const ElementSlots<float>& slots, const Strip<float>& search,
                        const Stiffening<float>& curve, float weight, float least_across,
                        StripForce<float>& product) {
  HWY_DYNAMIC_DISPATCH(multiply_stiffness_float)(slots, search, curve, weight, least_across, product);
}

void multiply_stiffness(const ElementSlots<double>& slots, const Strip<double>& search,
                        const Stiffening<double>& curve, double weight, double least_across,
                        StripForce<double>& product) {
  HWY_DYNAMIC_DISPATCH(multiply_stiffness_double)(slots, search, curve, weight, least_across, product);
}

Elements elements_of(const StiffeningSprings& stiffening, const Springs& springs) {
  Elements elements{2, 2};
  if (stiffening.quadratic == 0.0 && stiffening.cubic == 0.0) return elements;
  for (const Index s : chosen_springs(stiffening.springs, springs)) {
    const double rest = springs.rest_length[s];
    elements.add({springs.first[s], springs.second[s]}, {springs.stiffness[s] * rest, 1.0 / rest});
  }
  return elements;
}

template <class Real>
class StiffeningForce final : public CompiledEffect<Real> {
 public:
  StiffeningForce(const StiffeningSprings& stiffening, const EffectContext<Real>& context)
      : slots_(make_element_slots<Real>(elements_of(stiffening, context.scene.springs), context.model.order)),
        quadratic_(stiffening.quadratic),
        cubic_(stiffening.cubic) {}

  unsigned parts() const override {
    return slots_.slots.empty() ? 0 : has_force | is_coupled | has_own_derivative;
  }

  void add_force(const Strip<Real>& strip, double, StripForce<Real>& force) const override {
    stiffen(slots_, strip, curve(), force);
  }

  void add_derivative(const Strip<Real>& strip, double, const DerivativeWeights<Real>& weights,
                      StripBlocks<Real>& blocks) const override {
    const auto derivative_of = [&](const ElementCorner<Real>& spring, double length) -> AxialDerivative {
      const double pull = double(weights.stiffness) * spring.coefficients[0];
      const double strain = length * spring.coefficients[1] - 1.0, size = std::abs(strain);
      const double tension = pull * strain * size * (quadratic_ + cubic_ * size);
      return {pull * spring.coefficients[1] * size * (2.0 * quadratic_ + 3.0 * cubic_ * size),
              std::max(tension / length, 0.0)};
    };
    add_axial_blocks(slots_, strip, derivative_of, blocks);
  }

  /// (a - b)^2 <= 2 (a^2 + b^2).
  double coupling() const override { return 2.0; }

  void add_product(const Strip<Real>& search, const DerivativeWeights<Real>& weights, Curvature curvature,
                   StripForce<Real>& product) const override {
    const Real least = curvature == Curvature::convex ? Real(0) : std::numeric_limits<Real>::lowest();
    multiply_stiffness(slots_, search, curve(), weights.stiffness, least, product);
  }

  std::size_t reach() const override { return slots_.reach; }

  double energy(const Strip<Real>& strip) const override {
    return axial_energy(slots_, strip, [this](const ElementCorner<Real>& spring, double length) {
      const double size = std::abs(length * spring.coefficients[1] - 1.0);
      const double scale = spring.coefficients[0] / spring.coefficients[1];  // k l0^2
      return scale * size * size * size * (quadratic_ / 3.0 + cubic_ * size / 4.0);
    });
  }

  Stage stage() const override {
    return {std::string(StiffeningSprings::name), {}, {"position"}, {"force"}, slots_.bytes()};
  }

 private:
  Stiffening<Real> curve() const { return {Real(quadratic_), Real(cubic_)}; }

  ElementSlots<Real> slots_;
  double quadratic_, cubic_;
};

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const StiffeningSprings& stiffening, const EffectContext<Real>& context) {
  return std::make_unique<StiffeningForce<Real>>(stiffening, context);
}

template EffectPointer<float> compile_effect(const StiffeningSprings&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const StiffeningSprings&, const EffectContext<double>&);

void check_effect(const StiffeningSprings& stiffening, const Scene& scene, const ElementChecks& checks) {
  checks.not_negative("quadratic", stiffening.quadratic, "");
  checks.not_negative("cubic", stiffening.cubic, "");
  check_strained_springs(stiffening.springs, scene, checks);
  check_only_law(stiffening, scene, checks);
}

/// The stiffness along a spring, k (2 q |s| + 3 c s^2), counts twice for each end: it is more than that
/// across.
void add_bounds(const StiffeningSprings& stiffening, const Scene& scene, HeldParticles& held) {
  constexpr double least_strain = 0.25;
  if (stiffening.quadratic == 0.0 && stiffening.cubic == 0.0) return;
  const Springs& springs = scene.springs;
  for (const Index s : chosen_springs(stiffening.springs, springs)) {
    const Index a = springs.first[s], b = springs.second[s];
    const double length = (scene.particles.position[b] - scene.particles.position[a]).norm();
    const double strain = std::max(std::abs(length / springs.rest_length[s] - 1.0), least_strain);
    const double stiffness =
        springs.stiffness[s] * strain * (2.0 * stiffening.quadratic + 3.0 * stiffening.cubic * strain);
    held.add(a, 2.0 * stiffness, 0.0);
    held.add(b, 2.0 * stiffness, 0.0);
  }
}

}  // namespace hooke
#endif
