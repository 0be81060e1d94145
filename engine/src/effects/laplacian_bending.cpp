#include "effects/effect_functions.h"
#include "model/element_slots.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/laplacian_bending.cpp"
#include <hwy/foreach_target.h>

#include "kernels/elements-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

/// What each of the three particles counts for in x_first - 2 x_middle + x_last.
template <std::size_t role>
inline constexpr double weight = role == 1 ? -2.0 : 1.0;

/// F = -k w (x_0 - 2 x_1 + x_2).
struct Law {
  static constexpr std::size_t corners = 3, coefficients = 1;
  static constexpr bool velocities = false;

  template <std::size_t role, class D, class Element>
  HWY_INLINE auto force(D d, const Element& e) const {
    using Real = hn::TFromD<D>;
    const auto bend = (e.x[0] - e.x[1]) - (e.x[1] - e.x[2]);
    return scaled(hn::Mul(hn::Set(d, Real(-weight<role>)), e.c[0]), bend);
  }
};

/// The same for a direction in place of positions: K is constant, and this is K p.
template <class Real>
struct ProductLaw {
  static constexpr std::size_t corners = 3, coefficients = 1;
  static constexpr bool velocities = true;
  Real stiffness_weight;

  template <std::size_t role, class D, class Element>
  HWY_INLINE auto force(D d, const Element& e) const {
    const auto bend = (e.v[0] - e.v[1]) - (e.v[1] - e.v[2]);
    return scaled(hn::Mul(hn::Set(d, stiffness_weight * Real(weight<role>)), e.c[0]), bend);
  }
};

}  // namespace

void bend_float(const ElementSlots<float>& slots, const Strip<float>& strip, StripForce<float>& force) {
  add_element_forces(slots, strip, Law{}, force);
}

void bend_double(const ElementSlots<double>& slots, const Strip<double>& strip, StripForce<double>& force) {
  add_element_forces(slots, strip, Law{}, force);
}

void multiply_bend_float(const ElementSlots<float>& slots, const Strip<float>& search, float weight,
                         StripForce<float>& product) {
  add_element_forces(slots, search, ProductLaw<float>{weight}, product);
}

void multiply_bend_double(const ElementSlots<double>& slots, const Strip<double>& search, double weight,
                          StripForce<double>& product) {
  add_element_forces(slots, search, ProductLaw<double>{weight}, product);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {
namespace {

HWY_EXPORT(bend_float);
HWY_EXPORT(bend_double);
HWY_EXPORT(multiply_bend_float);
HWY_EXPORT(multiply_bend_double);

void bend(const ElementSlots<float>& slots, const Strip<float>& strip, StripForce<float>& force) {
  HWY_DYNAMIC_DISPATCH(bend_float)(slots, strip, force);
}

void bend(const ElementSlots<double>& slots, const Strip<double>& strip, StripForce<double>& force) {
  HWY_DYNAMIC_DISPATCH(bend_double)(slots, strip, force);
}

void multiply_bend(const ElementSlots<float>& slots, const Strip<float>& search, float weight,
                   StripForce<float>& product) {
  HWY_DYNAMIC_DISPATCH(multiply_bend_float)(slots, search, weight, product);
}

void multiply_bend(const ElementSlots<double>& slots, const Strip<double>& search, double weight,
                   StripForce<double>& product) {
  HWY_DYNAMIC_DISPATCH(multiply_bend_double)(slots, search, weight, product);
}

Elements elements_of(const LaplacianBending& bending) {
  Elements elements{3, 1};
  for (std::size_t i = 0; i < bending.stiffness.size(); ++i)
    elements.add({bending.first[i], bending.middle[i], bending.last[i]}, {bending.stiffness[i]});
  return elements;
}

template <class Real>
class LaplacianBendingForce final : public CompiledEffect<Real> {
 public:
  LaplacianBendingForce(const LaplacianBending& bending, const Order& order)
      : slots_(make_element_slots<Real>(elements_of(bending), order)) {}

  unsigned parts() const override { return has_force | is_coupled | has_own_derivative; }

  void add_force(const Strip<Real>& strip, double, StripForce<Real>& force) const override {
    bend(slots_, strip, force);
  }

  void add_derivative(const Strip<Real>& strip, double, const DerivativeWeights<Real>& weights,
                      StripBlocks<Real>& blocks) const override {
    for_each_corner(slots_, strip, [&](const auto& corner) {
      const double w = corner.role == 1 ? -2.0 : 1.0;
      const Real own = weights.stiffness * Real(w * w * corner.coefficients[0]);
      const std::size_t lane = corner.own - strip.first;
      blocks.xx[lane] += own;
      blocks.yy[lane] += own;
      blocks.zz[lane] += own;
    });
  }

  /// (a + b + c)^2 <= 3 (a^2 + b^2 + c^2).
  double coupling() const override { return 3.0; }

  void add_product(const Strip<Real>& search, const DerivativeWeights<Real>& weights, Curvature,
                   StripForce<Real>& product) const override {
    multiply_bend(slots_, search, weights.stiffness, product);
  }

  std::size_t reach() const override { return slots_.reach; }

  double energy(const Strip<Real>& strip) const override {
    double sum = 0.0;
    for_each_corner(slots_, strip, [&](const auto& corner) {
      const auto at = [&](std::size_t c) -> Vec3 {
        return strip.state.position(corner.particles[c]).template cast<double>();
      };
      sum += 0.5 / 3.0 * corner.coefficients[0] * ((at(0) - at(1)) - (at(1) - at(2))).squaredNorm();
    });
    return sum;
  }

  Stage stage() const override {
    return {std::string(LaplacianBending::name), {}, {"position"}, {"force"}, slots_.bytes()};
  }

 private:
  ElementSlots<Real> slots_;
};

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const LaplacianBending& bending, const EffectContext<Real>& context) {
  return std::make_unique<LaplacianBendingForce<Real>>(bending, context.model.order);
}

template EffectPointer<float> compile_effect(const LaplacianBending&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const LaplacianBending&, const EffectContext<double>&);

void check_effect(const LaplacianBending& bending, const Scene& scene, const ElementChecks& checks) {
  const std::size_t count = bending.stiffness.size();
  if (bending.first.size() != count || bending.middle.size() != count || bending.last.size() != count) {
    checks.add("first, middle, last and stiffness differ in length: " + std::to_string(bending.first.size()) +
                   ", " + std::to_string(bending.middle.size()) + ", " + std::to_string(bending.last.size()) +
                   ", " + std::to_string(count),
               "give each the same number of values");
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = [number = std::to_string(i)](std::string list) {
      return list.append("[").append(number).append("]");
    };
    checks.in_range(at("first"), bending.first[i], scene.particles.size(), "particles");
    checks.in_range(at("middle"), bending.middle[i], scene.particles.size(), "particles");
    checks.in_range(at("last"), bending.last[i], scene.particles.size(), "particles");
    checks.not_negative(at("stiffness"), bending.stiffness[i], "N/m");
    if (bending.first[i] == bending.middle[i] || bending.middle[i] == bending.last[i] ||
        bending.first[i] == bending.last[i])
      checks.add("entry " + std::to_string(i) + " has a particle twice", "give three different particles");
  }
}

/// The matrix k w w^T with w = (1, -2, 1) has the largest eigenvalue 6 k; of its rows the sums are at most 4
/// k and 8 k.
void add_bounds(const LaplacianBending& bending, const Scene&, HeldParticles& held) {
  for (std::size_t i = 0; i < bending.stiffness.size(); ++i) {
    const double k = bending.stiffness[i];
    held.add(bending.first[i], 4.0 * k, 0.0);
    held.add(bending.middle[i], 8.0 * k, 0.0);
    held.add(bending.last[i], 4.0 * k, 0.0);
  }
}

}  // namespace hooke
#endif
