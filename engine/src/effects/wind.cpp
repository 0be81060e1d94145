#include <algorithm>
#include <limits>
#include <optional>

#include <Eigen/Geometry>

#include "effects/effect_functions.h"
#include "effects/field_at.h"
#include "effects/field_checks.h"
#include "effects/largest_value.h"
#include "kernels/flush_subnormals.h"
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

/// The same everywhere.
template <class Real>
struct AirVelocity {
  Real x, y, z;  ///< [m/s]
};

}  // namespace hooke
#endif

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

/// The same third of a triangle's force on each of its corners. With N the cross product of two edges, A =
/// |N| / 2, it is written so that a division by |N| or |w| comes late, and of none that vanishes.
template <class Real>
struct WindLaw {
  static constexpr std::size_t corners = 3, coefficients = 1;
  static constexpr bool velocities = true;
  WindCoefficients<Real> of;
  AirVelocity<Real> air;

  template <std::size_t, class D, class Element>
  HWY_INLINE auto force(D d, const Element& e) const {
    const auto third = hn::Set(d, Real(1.0 / 3.0)), half = hn::Set(d, Real(0.5));
    const auto least = hn::Set(d, std::numeric_limits<Real>::min());
    const Vector3<hn::Vec<D>> u{hn::Set(d, air.x), hn::Set(d, air.y), hn::Set(d, air.z)};
    const auto w = u - scaled(third, e.v[0] + e.v[1] + e.v[2]);
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
  void blow_##Real(const ElementSlots<Real>& slots, const Strip<Real>& strip,                        \
                   const WindCoefficients<Real>& of, const AirVelocity<Real>& air,                   \
                   StripForce<Real>& force) {                                                        \
    add_element_forces(slots, strip, WindLaw<Real>{of, air}, force);                                 \
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
  HWY_EXPORT(blow_##Real);                                                                               \
  HWY_EXPORT(multiply_wind_##Real);                                                                      \
  void blow(const ElementSlots<Real>& slots, const Strip<Real>& strip, const WindCoefficients<Real>& of, \
            const AirVelocity<Real>& air, StripForce<Real>& force) {                                     \
    HWY_DYNAMIC_DISPATCH(blow_##Real)(slots, strip, of, air, force);                                     \
  }                                                                                                      \
  void multiply(const ElementSlots<Real>& slots, const Strip<Real>& search, Real weight,                 \
                StripForce<Real>& product) {                                                             \
    HWY_DYNAMIC_DISPATCH(multiply_wind_##Real)(slots, search, weight, product);                          \
  }
HOOKE_WIND_IN(float)
HOOKE_WIND_IN(double)
#undef HOOKE_WIND_IN

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

/// Uniform air is the same for each triangle. Other air is looked up once for each particle, before the
/// force: a particle's triangles all ask for it, and each of them in the sweep of each of its corners.
template <class Real>
class WindForce final : public CompiledEffect<Real> {
 public:
  WindForce(const Wind& wind, const EffectContext<Real>& context)
      : wind_(wind),
        of_{Real(wind.air_density * wind.drag / 6.0), Real(wind.air_density * wind.lift / 6.0)},
        triangles_(make_element_slots<Real>(triangles_of(context.scene), context.model.order)),
        dampers_(make_element_slots<Real>(dampers_of(wind, context.scene), context.model.order)) {
    if (!uniform()) against_air_.emplace(context.model.particles());
  }

  /// Wind without drag and lift has no part in a step.
  unsigned parts() const override {
    if (!blows(wind_)) return 0;
    return has_force | is_coupled | has_own_derivative | (uniform() ? 0u : needs_preparation);
  }

  void prepare(const State<Real>& state, double time, Executor& executor) override {
    executor.parallel_for(block_count(state.size()), strip_blocks, [&](std::size_t begin, std::size_t end) {
      const FlushSubnormals flush;
      // A field's function is for one thread alone.
      with_field_at(wind_.velocity, wind_.envelope, time, [&](const auto& field) {
        for (std::size_t block = begin; block < end; ++block) {
          if (has_triangles(block)) subtract_air(field, Strip<Real>(state, block, block + 1));
        }
      });
    });
  }

  void add_force(const Strip<Real>& strip, double time, StripForce<Real>& force) const override {
    if (const auto* air = std::get_if<UniformField>(&wind_.velocity)) {
      const Vec3 u = factor_at(wind_.envelope, time) * air->value;
      blow(triangles_, strip, of_, {Real(u.x()), Real(u.y()), Real(u.z())}, force);
      return;
    }
    const std::size_t begin = strip.first / block_size, end = begin + strip.lanes / block_size;
    blow(triangles_, Strip<Real>(*against_air_, begin, end), of_, {Real(0), Real(0), Real(0)}, force);
  }

  void add_derivative(const Strip<Real>& strip, double, const DerivativeWeights<Real>& weights,
                      StripBlocks<Real>& blocks) const override {
    for_each_corner(dampers_, strip, [&](const auto& corner) {
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

  void disturb(double from, double to, Disturbances& disturbed) const override {
    if (blows(wind_) && changes(wind_.velocity, wind_.envelope, from, to)) disturbed.all();
  }

  bool calls_user() const override { return std::holds_alternative<CallbackField>(wind_.velocity); }

  Stage stage() const override {
    const std::vector<std::string> reads = uniform()
                                               ? std::vector<std::string>{"position", "velocity", "time"}
                                               : std::vector<std::string>{"position", air_velocity};
    return {std::string(Wind::name), {}, reads, {"force"}, triangles_.bytes() + dampers_.bytes()};
  }

  Stage preparation_stage() const override {
    return {std::string(Wind::name) + " (air)",
            {},
            {"position", "velocity", "time"},
            {air_velocity},
            against_air_->bytes()};
  }

 private:
  static constexpr const char* air_velocity = "velocity against the air";

  bool uniform() const { return std::holds_alternative<UniformField>(wind_.velocity); }

  bool has_triangles(std::size_t block) const {
    const auto& list = triangles_.list(block);
    return list.begin != list.end;
  }

  template <class FieldAt>
  void subtract_air(const FieldAt& field, const Strip<Real>& strip) {
    for (std::size_t lane = 0; lane < strip.particles; ++lane) {
      const Eigen::Matrix<Real, 3, 1> x(strip.x[lane], strip.y[lane], strip.z[lane]);
      const Eigen::Matrix<Real, 3, 1> v(strip.vx[lane], strip.vy[lane], strip.vz[lane]);
      against_air_->set_position(strip.first + lane, x);
      against_air_->set_velocity(strip.first + lane,
                                 v - field(x.template cast<double>()).template cast<Real>());
    }
  }

  Wind wind_;
  WindCoefficients<Real> of_;
  ElementSlots<Real> triangles_, dampers_;
  std::optional<State<Real>> against_air_;  ///< velocities less that of the air, where it is not uniform
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
