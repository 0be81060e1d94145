#include <cmath>

#include "effects/effect_functions.h"
#include "model/element_slots.h"
#include "model/hinges.h"
#include "scene/chosen_triangles.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/hinge_bending.cpp"
#include <hwy/foreach_target.h>

#include "kernels/elements-inl.h"
#include "kernels/hinge-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

/// F = -k (theta - theta0 + damping dtheta/dt) grad theta. The coefficients of a hinge are k, cos(theta0) and
/// sin(theta0).
template <class Real, bool damped>
struct Law {
  static constexpr std::size_t corners = 4, coefficients = 3;
  static constexpr bool velocities = damped;
  Real damping;  ///< [s]

  template <std::size_t role, class D, class Element>
  HWY_INLINE auto force(D d, const Element& e) const {
    using V = hn::Vec<D>;
    const LaneHinge<V> hinge(d, e.x);
    V angle = hinge.angle_from(d, e.c[1], e.c[2]);
    if constexpr (damped) angle = hn::MulAdd(hn::Set(d, damping), hinge.rate(e.v), angle);
    const V moment = hn::Neg(hn::Mul(e.c[0], angle));
    return only_where(hinge.there, scaled(moment, hinge.template gradient_at<role>(d)));
  }
};

/// The derivative times a direction, which is in place of velocities: k grad theta (grad theta . p), and
/// where it is the exact one, the change of grad theta too.
template <class Real, bool exact>
struct ProductLaw {
  static constexpr std::size_t corners = 4, coefficients = 3;
  static constexpr bool velocities = true;
  Real along;   ///< weight of the first part
  Real turned;  ///< of the second one

  template <std::size_t role, class D, class Element>
  HWY_INLINE auto force(D d, const Element& e) const {
    using V = hn::Vec<D>;
    const LaneHinge<V> hinge(d, e.x);
    const V rate = hn::Mul(hn::Mul(hn::Set(d, along), e.c[0]), hinge.rate(e.v));
    auto product = scaled(rate, hinge.template gradient_at<role>(d));
    if constexpr (exact) {
      const V moment = hn::Mul(hn::Mul(hn::Set(d, turned), e.c[0]), hinge.angle_from(d, e.c[1], e.c[2]));
      product = product + scaled(moment, hinge.template gradient_rate_at<role>(d, e.v));
    }
    return only_where(hinge.there, product);
  }
};

template <class Real>
HWY_INLINE void hinge_forces(const ElementSlots<Real>& slots, const Strip<Real>& strip, Real damping,
                             StripForce<Real>& force) {
  if (damping == Real(0))
    add_element_forces(slots, strip, Law<Real, false>{damping}, force);
  else
    add_element_forces(slots, strip, Law<Real, true>{damping}, force);
}

template <class Real>
HWY_INLINE void hinge_products(const ElementSlots<Real>& slots, const Strip<Real>& search, Real along,
                               Real turned, StripForce<Real>& product) {
  if (turned == Real(0))
    add_element_forces(slots, search, ProductLaw<Real, false>{along, turned}, product);
  else
    add_element_forces(slots, search, ProductLaw<Real, true>{along, turned}, product);
}

}  // namespace

void hinges_float(const ElementSlots<float>& slots, const Strip<float>& strip, float damping,
                  StripForce<float>& force) {
  hinge_forces(slots, strip, damping, force);
}

void hinges_double(const ElementSlots<double>& slots, const Strip<double>& strip, double damping,
                   StripForce<double>& force) {
  hinge_forces(slots, strip, damping, force);
}

void multiply_hinges_float(const ElementSlots<float>& slots, const Strip<float>& search, float along,
                           float turned, StripForce<float>& product) {
  hinge_products(slots, search, along, turned, product);
}

void multiply_hinges_double(const ElementSlots<double>& slots, const Strip<double>& search, double along,
                            double turned, StripForce<double>& product) {
  hinge_products(slots, search, along, turned, product);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {
namespace {

HWY_EXPORT(hinges_float);
HWY_EXPORT(hinges_double);
HWY_EXPORT(multiply_hinges_float);
HWY_EXPORT(multiply_hinges_double);

void bend(const ElementSlots<float>& slots, const Strip<float>& strip, float damping,
          StripForce<float>& force) {
  HWY_DYNAMIC_DISPATCH(hinges_float)(slots, strip, damping, force);
}

void bend(const ElementSlots<double>& slots, const Strip<double>& strip, double damping,
          StripForce<double>& force) {
  HWY_DYNAMIC_DISPATCH(hinges_double)(slots, strip, damping, force);
}

void multiply(const ElementSlots<float>& slots, const Strip<float>& search, float along, float turned,
              StripForce<float>& product) {
  HWY_DYNAMIC_DISPATCH(multiply_hinges_float)(slots, search, along, turned, product);
}

void multiply(const ElementSlots<double>& slots, const Strip<double>& search, double along, double turned,
              StripForce<double>& product) {
  HWY_DYNAMIC_DISPATCH(multiply_hinges_double)(slots, search, along, turned, product);
}

Elements elements_of(const HingeBending& bending, const Scene& scene) {
  Elements elements{4, 3};
  if (bending.stiffness == 0.0) return elements;
  for (const Hinge& hinge : hinges_of(scene, chosen_triangles(scene, bending.triangles))) {
    const double rest = bending.flat_at_rest ? 0.0 : hinge_angle(corners_of(hinge, scene)).angle;
    const auto& p = hinge.particles;
    elements.add({p[0], p[1], p[2], p[3]},
                 {bending.stiffness * hinge.stretch, std::cos(rest), std::sin(rest)});
  }
  return elements;
}

template <class Real>
class HingeBendingForce final : public CompiledEffect<Real> {
 public:
  HingeBendingForce(const HingeBending& bending, const EffectContext<Real>& context)
      : damping_(Real(bending.damping)),
        slots_(make_element_slots<Real>(elements_of(bending, context.scene), context.model.order)) {}

  unsigned parts() const override { return has_force | is_coupled | has_own_derivative; }

  void add_force(const Strip<Real>& strip, double, StripForce<Real>& force) const override {
    bend(slots_, strip, damping_, force);
  }

  /// k grad theta grad theta^T, without the change of grad theta, which is indefinite.
  void add_derivative(const Strip<Real>& strip, double, const DerivativeWeights<Real>& weights,
                      StripBlocks<Real>& blocks) const override {
    const double weight = double(weight_along(weights));
    for_each_corner(slots_, strip, [&](const auto& corner) {
      const Vec3 gradient = hinge_angle(corners(strip.state, corner)).gradient[corner.role];
      const Eigen::Matrix3d own = weight * corner.coefficients[0] * gradient * gradient.transpose();
      add_matrix(own, corner.own - strip.first, blocks);
    });
  }

  /// (a + b + c + d)^2 <= 4 (a^2 + b^2 + c^2 + d^2).
  double coupling() const override { return 4.0; }

  /// The exact one is that of a state at rest: a damper's force changes with positions too where it moves.
  void add_product(const Strip<Real>& search, const DerivativeWeights<Real>& weights, Curvature curvature,
                   StripForce<Real>& product) const override {
    multiply(slots_, search, weight_along(weights),
             curvature == Curvature::exact ? weights.stiffness : Real(0), product);
  }

  std::size_t reach() const override { return slots_.reach; }

  double energy(const Strip<Real>& strip) const override {
    double sum = 0.0;
    for_each_corner(slots_, strip, [&](const auto& corner) {
      const double rest = std::atan2(corner.coefficients[2], corner.coefficients[1]);
      const HingeCorners at = corners(strip.state, corner);
      const HingeAngle now = hinge_angle(at);
      if (now.gradient[2].isZero(0.0)) return;
      const double bend = std::remainder(now.angle - rest, 2.0 * pi);
      sum += 0.5 / 4.0 * corner.coefficients[0] * bend * bend;
    });
    return sum;
  }

  Stage stage() const override {
    std::vector<std::string> reads{"position"};
    if (damping_ != Real(0)) reads.push_back("velocity");
    return {std::string(HingeBending::name), {}, reads, {"force"}, slots_.bytes()};
  }

 private:
  static constexpr double pi = 3.14159265358979323846;

  Real weight_along(const DerivativeWeights<Real>& weights) const {
    return weights.stiffness + weights.damping * damping_;
  }

  static HingeCorners corners(const State<Real>& state, const ElementCorner<Real>& corner) {
    HingeCorners at;
    for (std::size_t c = 0; c < at.size(); ++c)
      at[c] = state.position(corner.particles[c]).template cast<double>();
    return at;
  }

  Real damping_;  // [s]
  ElementSlots<Real> slots_;
};

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const HingeBending& bending, const EffectContext<Real>& context) {
  return std::make_unique<HingeBendingForce<Real>>(bending, context);
}

template EffectPointer<float> compile_effect(const HingeBending&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const HingeBending&, const EffectContext<double>&);

void check_effect(const HingeBending& bending, const Scene& scene, const ElementChecks& checks) {
  checks.not_negative("stiffness", bending.stiffness, "N m");
  checks.not_negative("damping", bending.damping, "s");
  if (scene.triangles.empty()) {
    checks.add("the scene has no triangles that could bend",
               "give triangles, as cloth grids and meshes do, or use laplacian_bending along lines");
    return;
  }
  check_chosen_triangles(scene, bending.triangles, checks);
}

/// The matrix k g g^T, with g the gradients of the angle at the four corners, is at most the diagonal one of
/// the sums of its rows. That is of the shape at the start; half as much again is for shapes to come: hinges
/// folded to about a right angle from rest, or heights of triangles less by a fifth.
void add_bounds(const HingeBending& bending, const Scene& scene, HeldParticles& held) {
  constexpr double reserve = 1.5;
  if (bending.stiffness == 0.0) return;
  for (const Hinge& hinge : hinges_of(scene, chosen_triangles(scene, bending.triangles))) {
    const HingeAngle at_start = hinge_angle(corners_of(hinge, scene));
    double sum = 0.0;
    for (const Vec3& gradient : at_start.gradient) sum += gradient.norm();
    for (std::size_t c = 0; c < hinge.particles.size(); ++c) {
      const double k = reserve * bending.stiffness * hinge.stretch * sum * at_start.gradient[c].norm();
      held.add(hinge.particles[c], k, bending.damping * k);
    }
  }
}

}  // namespace hooke
#endif
