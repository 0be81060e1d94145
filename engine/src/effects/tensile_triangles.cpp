#include <algorithm>

#include "effects/effect_functions.h"
#include "effects/tensile_stiffness.h"
#include "model/element_slots.h"
#include "scene/number_text.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/tensile_triangles.cpp"
#include <hwy/foreach_target.h>

#include "kernels/elements-inl.h"

// With q = l^2 - L^2 of the sides, the tensions T = C q (see TensileStiffness),
//   C q = b (b.q) + s (2 q - sum of q),
// pull corner r to the two others:
//   F_r = T_b (x_a - x_r) + T_a (x_b - x_r), where side i is opposite corner i, and a, b are the corners
//   after r.
// The coefficients of an element are s, b_0, b_1, b_2, L_0^2, L_1^2, L_2^2.

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

constexpr std::size_t after(std::size_t corner, std::size_t steps) {
  return (corner + steps) % 3;
}

/// Something of each side of a triangle.
template <class V>
struct OfSides {
  V value[3];
};

/// C q.
template <class D, class Element, class V = hn::Vec<D>>
HWY_INLINE OfSides<V> tensions(D d, const Element& e, const OfSides<V>& q) {
  const V sum = hn::Add(q.value[0], hn::Add(q.value[1], q.value[2]));
  const V along = hn::MulAdd(e.c[1], q.value[0], hn::MulAdd(e.c[2], q.value[1], hn::Mul(e.c[3], q.value[2])));
  OfSides<V> t;
  for (std::size_t i = 0; i < 3; ++i) {
    const V rest = hn::MulSub(hn::Set(d, hn::TFromD<D>(2)), q.value[i], sum);
    t.value[i] = hn::MulAdd(e.c[1 + i], along, hn::Mul(e.c[0], rest));
  }
  return t;
}

template <class Element>
HWY_INLINE auto side(const Element& e, std::size_t i) {
  return e.x[after(i, 2)] - e.x[after(i, 1)];
}

/// l_i^2 - L_i^2.
template <class D, class Element, class V = hn::Vec<D>>
HWY_INLINE OfSides<V> stretches(D, const Element& e) {
  OfSides<V> q;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto across = side(e, i);
    q.value[i] = hn::Sub(dot(across, across), e.c[4 + i]);
  }
  return q;
}

/// Their change along the velocities or the direction.
template <class D, class Element, class V = hn::Vec<D>>
HWY_INLINE OfSides<V> rates(D d, const Element& e) {
  OfSides<V> q;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto change = e.v[after(i, 2)] - e.v[after(i, 1)];
    q.value[i] = hn::Mul(hn::Set(d, hn::TFromD<D>(2)), dot(side(e, i), change));
  }
  return q;
}

/// What tensions of the sides do to a corner, where `x` are the places of the corners.
template <std::size_t role, class V>
HWY_INLINE Vector3<V> pull(const OfSides<V>& t, const Vector3<V> (&x)[3]) {
  constexpr std::size_t a = after(role, 1), b = after(role, 2);
  return scaled(t.value[b], x[a] - x[role]) + scaled(t.value[a], x[b] - x[role]);
}

struct ElasticLaw {
  static constexpr std::size_t corners = 3, coefficients = 7;
  static constexpr bool velocities = false;

  template <std::size_t role, class D, class Element>
  HWY_INLINE auto force(D d, const Element& e) const {
    return pull<role>(tensions(d, e, stretches(d, e)), e.x);
  }
};

/// With the rates of strain resisted too.
template <class Real>
struct DampedLaw {
  static constexpr std::size_t corners = 3, coefficients = 7;
  static constexpr bool velocities = true;
  Real damping;

  template <std::size_t role, class D, class Element>
  HWY_INLINE auto force(D d, const Element& e) const {
    auto q = stretches(d, e);
    const auto rate = rates(d, e);
    for (std::size_t i = 0; i < 3; ++i)
      q.value[i] = hn::MulAdd(hn::Set(d, damping), rate.value[i], q.value[i]);
    return pull<role>(tensions(d, e, q), e.x);
  }
};

/// The derivative times a direction: the tensions change with the lengths, which has no negative eigenvalues,
/// and turn with the sides, which has where a side is pressed; the convex kind leaves pressed sides out.
template <class Real>
struct ProductLaw {
  static constexpr std::size_t corners = 3, coefficients = 7;
  static constexpr bool velocities = true;
  Real stretching, turning;  ///< how much the two count
  bool convex;

  template <std::size_t role, class D, class Element>
  HWY_INLINE auto force(D d, const Element& e) const {
    auto changed = tensions(d, e, rates(d, e));
    auto kept = tensions(d, e, stretches(d, e));
    for (std::size_t i = 0; i < 3; ++i) {
      if (convex) kept.value[i] = hn::Max(kept.value[i], hn::Zero(d));
      changed.value[i] = hn::Mul(hn::Set(d, -stretching), changed.value[i]);
      kept.value[i] = hn::Mul(hn::Set(d, -turning), kept.value[i]);
    }
    return pull<role>(changed, e.x) + pull<role>(kept, e.v);
  }
};

}  // namespace

void pull_float(const ElementSlots<float>& slots, const Strip<float>& strip, float damping,
                StripForce<float>& force) {
  if (damping == 0.0F) return add_element_forces(slots, strip, ElasticLaw{}, force);
  add_element_forces(slots, strip, DampedLaw<float>{damping}, force);
}

void pull_double(const ElementSlots<double>& slots, const Strip<double>& strip, double damping,
                 StripForce<double>& force) {
  if (damping == 0.0) return add_element_forces(slots, strip, ElasticLaw{}, force);
  add_element_forces(slots, strip, DampedLaw<double>{damping}, force);
}

void multiply_float(const ElementSlots<float>& slots, const Strip<float>& search, float stretching,
                    float turning, bool convex, StripForce<float>& product) {
  add_element_forces(slots, search, ProductLaw<float>{stretching, turning, convex}, product);
}

void multiply_double(const ElementSlots<double>& slots, const Strip<double>& search, double stretching,
                     double turning, bool convex, StripForce<double>& product) {
  add_element_forces(slots, search, ProductLaw<double>{stretching, turning, convex}, product);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {
namespace {

HWY_EXPORT(pull_float);
HWY_EXPORT(pull_double);
HWY_EXPORT(multiply_float);
HWY_EXPORT(multiply_double);

/// Calls visit(triangle) for the number of each triangle of the sheet.
template <class Visit>
void for_each_triangle(const TensileTriangles& sheet, const Scene& scene, const Visit& visit) {
  if (sheet.triangles.empty()) {
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) visit(t);
  } else {
    for (const Index t : sheet.triangles) visit(std::size_t(t));
  }
}

Corners corners_of(const Scene& scene, const Triangle& triangle) {
  const auto& position = scene.particles.position;
  return {position[triangle[0]], position[triangle[1]], position[triangle[2]]};
}

template <class Real>
StrainedTriangle strained(const ElementCorner<Real>& corner, const State<Real>& state) {
  const auto& c = corner.coefficients;
  StrainedTriangle triangle{{}, {c[0], {c[1], c[2], c[3]}}, {}};
  for (std::size_t i = 0; i < 3; ++i)
    triangle.x[i] = state.position(corner.particles[i]).template cast<double>();
  for (std::size_t i = 0; i < 3; ++i)
    triangle.stretch[Eigen::Index(i)] = side_of(triangle.x, i).squaredNorm() - c[4 + i];
  return triangle;
}

Elements elements_of(const TensileTriangles& sheet, const Scene& scene) {
  Elements elements{3, 7};
  if (sheet.modulus == 0.0) return elements;
  for_each_triangle(sheet, scene, [&](std::size_t t) {
    const Triangle& triangle = scene.triangles[t];
    const Corners x = corners_of(scene, triangle);
    const auto [s, b] = stiffness_of(sheet, x);
    elements.add({triangle[0], triangle[1], triangle[2]},
                 {s, b[0], b[1], b[2], side_of(x, 0).squaredNorm(), side_of(x, 1).squaredNorm(),
                  side_of(x, 2).squaredNorm()});
  });
  return elements;
}

template <class Real>
class TensileForce final : public CompiledEffect<Real> {
 public:
  TensileForce(const TensileTriangles& sheet, const EffectContext<Real>& context)
      : slots_(make_element_slots<Real>(elements_of(sheet, context.scene), context.model.order)),
        damping_(Real(sheet.damping)) {}

  unsigned parts() const override { return has_force | is_coupled | has_own_derivative; }

  void add_force(const Strip<Real>& strip, double, StripForce<Real>& force) const override {
    if constexpr (sizeof(Real) == 4) {
      HWY_DYNAMIC_DISPATCH(pull_float)(slots_, strip, damping_, force);
    } else {
      HWY_DYNAMIC_DISPATCH(pull_double)(slots_, strip, damping_, force);
    }
  }

  void add_derivative(const Strip<Real>& strip, double, const DerivativeWeights<Real>& weights,
                      StripBlocks<Real>& blocks) const override {
    const double stretching = double(stretching_weight(weights)), turning = double(weights.stiffness);
    for_each_corner(slots_, strip, [&](const auto& corner) {
      const Eigen::Matrix3d own =
          own_derivative(strained(corner, strip.state), corner.role, stretching, turning);
      add_matrix(own, corner.own - strip.first, blocks);
    });
  }

  /// Of a matrix without negative eigenvalues the blocks on the diagonal, times their number, are at least
  /// all.
  double coupling() const override { return 3.0; }

  void add_product(const Strip<Real>& search, const DerivativeWeights<Real>& weights, Curvature curvature,
                   StripForce<Real>& product) const override {
    const Real stretching = stretching_weight(weights);
    const bool convex = curvature == Curvature::convex;
    if constexpr (sizeof(Real) == 4) {
      HWY_DYNAMIC_DISPATCH(multiply_float)
      (slots_, search, stretching, weights.stiffness, convex, product);
    } else {
      HWY_DYNAMIC_DISPATCH(multiply_double)
      (slots_, search, stretching, weights.stiffness, convex, product);
    }
  }

  std::size_t reach() const override { return slots_.reach; }

  double energy(const Strip<Real>& strip) const override {
    double sum = 0.0;
    for_each_corner(slots_, strip, [&](const auto& corner) {
      const StrainedTriangle triangle = strained(corner, strip.state);
      const Vec3& stretch = triangle.stretch;
      sum += stretch.dot(triangle.stiffness.matrix() * stretch) / 12.0;
    });
    return sum;
  }

  Stage stage() const override {
    std::vector<std::string> reads{"position"};
    if (damping_ > Real(0)) reads.emplace_back("velocity");
    return {std::string(TensileTriangles::name), {}, std::move(reads), {"force"}, slots_.bytes()};
  }

 private:
  /// The rate of strain is resisted as strain is.
  Real stretching_weight(const DerivativeWeights<Real>& weights) const {
    return weights.stiffness + damping_ * weights.damping;
  }

  ElementSlots<Real> slots_;
  Real damping_;
};

void check_triangle(const Scene& scene, std::size_t t, const ElementChecks& checks) {
  const Triangle& triangle = scene.triangles[t];
  const std::size_t particles = scene.particles.size();
  for (const Index corner : triangle) {
    if (corner >= particles || !scene.particles.position[corner].allFinite()) return;  // reported as such
  }
  const Corners x = corners_of(scene, triangle);
  const double longest =
      std::max({side_of(x, 0).squaredNorm(), side_of(x, 1).squaredNorm(), side_of(x, 2).squaredNorm()});
  if (doubled_area(x) > 1e-12 * longest) return;
  checks.add("triangle " + std::to_string(t) + " has no area at the start",
             "give it one, or name the other triangles in `triangles`");
}

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const TensileTriangles& sheet, const EffectContext<Real>& context) {
  return std::make_unique<TensileForce<Real>>(sheet, context);
}

template EffectPointer<float> compile_effect(const TensileTriangles&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const TensileTriangles&, const EffectContext<double>&);

void check_effect(const TensileTriangles& sheet, const Scene& scene, const ElementChecks& checks) {
  checks.not_negative("modulus", sheet.modulus, "N/m");
  if (!(sheet.poisson_ratio > -1.0 && sheet.poisson_ratio < 1.0)) {
    checks.add("poisson_ratio is " + to_text(sheet.poisson_ratio), "give a value > -1 and < 1");
  }
  checks.not_negative("damping", sheet.damping, "s");
  for_each_triangle(sheet, scene, [&](std::size_t t) {
    if (t < scene.triangles.size()) {
      check_triangle(scene, t, checks);
    } else {
      checks.in_range("a triangle", Index(t), scene.triangles.size(), "triangles");
    }
  });
}

/// A stretched triangle is stiffer than at rest, as (3 s^2 - 1) / 2 where it is s times as long: the bound
/// holds up to 15 % of stretch.
void add_bounds(const TensileTriangles& sheet, const Scene& scene, HeldParticles& held) {
  if (sheet.modulus == 0.0) return;
  constexpr double when_stretched = 1.5;
  for_each_triangle(sheet, scene, [&](std::size_t t) {
    const Corners x = corners_of(scene, scene.triangles[t]);
    const double k = stiffness_of(sheet, x).largest_at_rest(x);
    for (const Index corner : scene.triangles[t])
      held.add(corner, when_stretched * k, when_stretched * sheet.damping * k);
  });
}

}  // namespace hooke
#endif
