#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

#include "effects/effect_functions.h"
#include "effects/field_at.h"
#include "effects/field_checks.h"
#include "effects/largest_value.h"
#include "model/element_slots.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/wind.cpp"
#include <hwy/foreach_target.h>

#include "kernels/elements-inl.h"

#ifndef HOOKE_WIND
#define HOOKE_WIND
namespace hooke {

/// What the law needs, in the precision of the run.
template <class Real>
struct WindCoefficients {
  Real drag, lift;  ///< times a sixth of the density [kg/m^3]
};

template <class Real>
struct UniformAir {
  Real x, y, z;  ///< [m/s]
};

/// Air whose velocity is asked for place by place. A vector of lanes at a time, as arrays; lanes where
/// `there` is zero have no triangle.
template <class Real>
struct AirAtPlaces {
  const void* field;
  void (*evaluate)(const void* field, std::size_t lanes, const Real* there, const Real* const* place,
                   Real* const* air);
};

}  // namespace hooke
#endif

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

template <class D, class Real, class V>
HWY_INLINE Vector3<V> velocity_of(D d, const UniformAir<Real>& air, V, const Vector3<V>&) {
  return {hn::Set(d, air.x), hn::Set(d, air.y), hn::Set(d, air.z)};
}

template <class D, class Real, class V>
HWY_INLINE Vector3<V> velocity_of(D d, const AirAtPlaces<Real>& air, V there, const Vector3<V>& place) {
  alignas(cache_line) Real marks[block_size], p[3][block_size], u[3][block_size];
  hn::Store(there, d, marks);
  hn::Store(place.x, d, p[0]);
  hn::Store(place.y, d, p[1]);
  hn::Store(place.z, d, p[2]);
  const Real* const places[] = {p[0], p[1], p[2]};
  Real* const airs[] = {u[0], u[1], u[2]};
  air.evaluate(air.field, hn::Lanes(d), marks, places, airs);
  return {hn::Load(d, u[0]), hn::Load(d, u[1]), hn::Load(d, u[2])};
}

/// The same third of a triangle's force on each of its corners. With N the cross product of two edges, A =
/// |N| / 2, it is written so that a division by |N| or |w| comes late, and of none that vanishes.
template <class Real, class Air>
struct WindLaw {
  static constexpr std::size_t corners = 3, coefficients = 1;
  static constexpr bool velocities = true;
  WindCoefficients<Real> of;
  Air air;

  template <std::size_t, class D, class Element>
  HWY_INLINE auto force(D d, const Element& e) const {
    const auto third = hn::Set(d, Real(1.0 / 3.0)), half = hn::Set(d, Real(0.5));
    const auto least = hn::Set(d, std::numeric_limits<Real>::min());
    const auto place = scaled(third, e.x[0] + e.x[1] + e.x[2]);
    const auto w = velocity_of(d, air, e.c[0], place) - scaled(third, e.v[0] + e.v[1] + e.v[2]);
    const auto N = cross(e.x[1] - e.x[0], e.x[2] - e.x[0]);
    const auto through = dot(N, w);  // 2 A (n.w), of either sign
    const auto length = hn::Sqrt(hn::Max(dot(N, N), least)), speed = hn::Sqrt(hn::Max(dot(w, w), least));
    const auto area_through = hn::Mul(half, hn::Abs(through));
    const auto slope = hn::Div(through, hn::Mul(length, speed));  // n.w / |w|, of either sign
    const auto lift = hn::Mul(area_through, hn::Set(d, of.lift));
    const auto drag = hn::Mul(area_through, hn::Set(d, of.drag));
    const auto along_wind = hn::NegMulAdd(lift, hn::Abs(slope), drag);
    const auto along_normal =
        hn::Mul(hn::Mul(lift, speed), hn::Div(hn::CopySign(hn::Set(d, Real(1)), through), length));
    return scaled(along_wind, w) + scaled(along_normal, N);
  }
};

/// c times the sum of a direction over the corners.
template <class Real>
struct WindProductLaw {
  static constexpr std::size_t corners = 3, coefficients = 1;
  static constexpr bool velocities = true;
  Real damping_weight;

  template <std::size_t, class D, class Element>
  HWY_INLINE auto force(D d, const Element& e) const {
    return scaled(hn::Mul(hn::Set(d, damping_weight), e.c[0]), e.v[0] + e.v[1] + e.v[2]);
  }
};

}  // namespace

#define HOOKE_WIND_IN(Real)                                                                          \
  void blow_uniform_##Real(const ElementSlots<Real>& slots, const Strip<Real>& strip,                \
                           const WindCoefficients<Real>& of, const UniformAir<Real>& air,            \
                           StripForce<Real>& force) {                                                \
    add_element_forces(slots, strip, WindLaw<Real, UniformAir<Real>>{of, air}, force);               \
  }                                                                                                  \
  void blow_places_##Real(const ElementSlots<Real>& slots, const Strip<Real>& strip,                 \
                          const WindCoefficients<Real>& of, const AirAtPlaces<Real>& air,            \
                          StripForce<Real>& force) {                                                 \
    add_element_forces(slots, strip, WindLaw<Real, AirAtPlaces<Real>>{of, air}, force);              \
  }                                                                                                  \
  void multiply_wind_##Real(const ElementSlots<Real>& slots, const Strip<Real>& search, Real weight, \
                            StripForce<Real>& product) {                                             \
    add_element_forces(slots, search, WindProductLaw<Real>{weight}, product);                        \
  }
HOOKE_WIND_IN(float)
HOOKE_WIND_IN(double)
#undef HOOKE_WIND_IN

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {
namespace {

#define HOOKE_WIND_IN(Real)                                                                              \
  HWY_EXPORT(blow_uniform_##Real);                                                                       \
  HWY_EXPORT(blow_places_##Real);                                                                        \
  HWY_EXPORT(multiply_wind_##Real);                                                                      \
  void blow(const ElementSlots<Real>& slots, const Strip<Real>& strip, const WindCoefficients<Real>& of, \
            const UniformAir<Real>& air, StripForce<Real>& force) {                                      \
    HWY_DYNAMIC_DISPATCH(blow_uniform_##Real)(slots, strip, of, air, force);                             \
  }                                                                                                      \
  void blow(const ElementSlots<Real>& slots, const Strip<Real>& strip, const WindCoefficients<Real>& of, \
            const AirAtPlaces<Real>& air, StripForce<Real>& force) {                                     \
    HWY_DYNAMIC_DISPATCH(blow_places_##Real)(slots, strip, of, air, force);                              \
  }                                                                                                      \
  void multiply(const ElementSlots<Real>& slots, const Strip<Real>& search, Real weight,                 \
                StripForce<Real>& product) {                                                             \
    HWY_DYNAMIC_DISPATCH(multiply_wind_##Real)(slots, search, weight, product);                          \
  }
HOOKE_WIND_IN(float)
HOOKE_WIND_IN(double)
#undef HOOKE_WIND_IN

template <class Real, class FieldAt>
AirAtPlaces<Real> air_of(const FieldAt& field) {
  const auto evaluate = [](const void* erased, std::size_t lanes, const Real* there, const Real* const* place,
                           Real* const* air) {
    const FieldAt& at = *static_cast<const FieldAt*>(erased);
    for (std::size_t i = 0; i < lanes; ++i) {
      const Vec3 u = there[i] != Real(0) ? at(Vec3(place[0][i], place[1][i], place[2][i])) : Vec3(0, 0, 0);
      for (std::size_t axis = 0; axis < 3; ++axis) air[axis][i] = Real(u[Eigen::Index(axis)]);
    }
  };
  return {&field, evaluate};
}

double fastest_particle(const Scene& scene) {
  double fastest = 0.0;
  for (const Vec3& velocity : scene.particles.velocity) fastest = std::max(fastest, velocity.norm());
  return fastest;
}

/// Of the derivative of a triangle's force by its velocity no more than this is the size [N s/m]: rho A |w|
/// (drag + lift), with A at the start and the greatest |w| as far as it is known. Drag has 2 |n.w| at most,
/// lift sqrt(2) |w|, times rho A / 2.
class TriangleDamping {
 public:
  TriangleDamping(const Wind& wind, const Scene& scene)
      : scene_(scene),
        for_each_area_(wind.air_density * (wind.drag + wind.lift) *
                       (largest_value(wind.velocity, wind.envelope, scene) + fastest_particle(scene))) {}

  double of(const Triangle& triangle) const {
    const auto& x = scene_.particles.position;
    const Vec3 a = x[triangle[1]] - x[triangle[0]], b = x[triangle[2]] - x[triangle[0]];
    return for_each_area_ * 0.5 * a.cross(b).norm();
  }

 private:
  const Scene& scene_;
  double for_each_area_;
};

Elements triangles_of(const Scene& scene) {
  Elements elements{3, 1};
  for (const auto& [a, b, c] : scene.triangles) elements.add({a, b, c}, {1.0});
  return elements;
}

/// Half of the greatest damping, as a matrix that is the same for each pair of corners: between nothing and
/// twice this lies the true derivative, so that iterations with it converge.
Elements dampers_of(const Wind& wind, const Scene& scene) {
  const TriangleDamping damping(wind, scene);
  Elements elements{3, 1};
  for (const Triangle& triangle : scene.triangles)
    elements.add({triangle[0], triangle[1], triangle[2]}, {0.5 * damping.of(triangle) / 9.0});
  return elements;
}

bool blows(const Wind& wind) {
  return wind.air_density > 0.0 && (wind.drag > 0.0 || wind.lift > 0.0);
}

template <class Real>
class WindForce final : public CompiledEffect<Real> {
 public:
  WindForce(const Wind& wind, const EffectContext<Real>& context)
      : wind_(wind),
        of_{Real(wind.air_density * wind.drag / 6.0), Real(wind.air_density * wind.lift / 6.0)},
        triangles_(make_element_slots<Real>(triangles_of(context.scene), context.model.order)),
        dampers_(make_element_slots<Real>(dampers_of(wind, context.scene), context.model.order)) {}

  /// Wind without drag and lift has no part in a step.
  unsigned parts() const override { return blows(wind_) ? has_force | is_coupled | has_own_derivative : 0; }

  void add_force(const Strip<Real>& strip, double time, StripForce<Real>& force) const override {
    if (const auto* uniform = std::get_if<UniformField>(&wind_.velocity)) {
      const Vec3 u = factor_at(wind_.envelope, time) * uniform->value;
      blow(triangles_, strip, of_, UniformAir<Real>{Real(u.x()), Real(u.y()), Real(u.z())}, force);
      return;
    }
    with_field_at(wind_.velocity, wind_.envelope, time,
                  [&](const auto& field) { blow(triangles_, strip, of_, air_of<Real>(field), force); });
  }

  void add_derivative(const Strip<Real>& strip, double, const DerivativeWeights<Real>& weights,
                      StripBlocks<Real>& blocks) const override {
    const std::size_t begin = strip.first / block_size;
    for_each_corner(dampers_, begin, begin + strip.lanes / block_size, [&](const auto& corner) {
      const std::size_t lane = corner.own - strip.first;
      const Real own = weights.damping * Real(corner.coefficients[0]);
      for (Real* const diagonal : {blocks.xx, blocks.yy, blocks.zz}) diagonal[lane] += own;
    });
  }

  double coupling() const override { return 3.0; }

  void add_product(const Strip<Real>& search, const DerivativeWeights<Real>& weights, Curvature,
                   StripForce<Real>& product) const override {
    multiply(dampers_, search, weights.damping, product);
  }

  std::size_t reach() const override { return triangles_.reach; }

  bool calls_user() const override { return std::holds_alternative<CallbackField>(wind_.velocity); }

  Stage stage() const override {
    return {std::string(Wind::name),
            {},
            {"position", "velocity", "time"},
            {"force"},
            triangles_.bytes() + dampers_.bytes()};
  }

 private:
  Wind wind_;
  WindCoefficients<Real> of_;
  ElementSlots<Real> triangles_, dampers_;
};

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const Wind& wind, const EffectContext<Real>& context) {
  return std::make_unique<WindForce<Real>>(wind, context);
}

template EffectPointer<float> compile_effect(const Wind&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const Wind&, const EffectContext<double>&);

void check_effect(const Wind& wind, const Scene& scene, const ElementChecks& checks) {
  if (scene.triangles.empty())
    checks.add("blows on triangles, and the scene has none",
               "add triangles, or let particle_wind blow on particles");
  checks.not_negative("air_density", wind.air_density, "kg/m^3");
  checks.not_negative("drag", wind.drag, "");
  checks.not_negative("lift", wind.lift, "");
  check_shape("velocity", wind.velocity, "m/s", checks);
  check_envelope(wind.envelope, checks);
}

/// With the same matrix c for each pair of a triangle's corners, over 9 as each has a third of the force and
/// of the velocity, the largest eigenvalue is 3 c / 9. How the force changes with a triangle's place is not
/// counted: it is next to nothing beside the springs that hold a cloth together.
void add_bounds(const Wind& wind, const Scene& scene, HeldParticles& held) {
  if (!blows(wind)) return;
  const TriangleDamping damping(wind, scene);
  for (const Triangle& triangle : scene.triangles) {
    const double of_each = damping.of(triangle) / 3.0;
    for (const Index corner : triangle) held.add(corner, 0.0, of_each);
  }
}

}  // namespace hooke
#endif
