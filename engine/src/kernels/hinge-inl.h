// Included once for each instruction set, after hwy/foreach_target.h.

#if defined(HOOKE_HINGE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HOOKE_HINGE_INL
#undef HOOKE_HINGE_INL
#else
#define HOOKE_HINGE_INL
#endif

#include <limits>

#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>

#include "kernels/elements-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

/// The angle of the vector (c, s) in the plane, from -pi to pi.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V angle_of(D d, V s, V c) {
  using Real = hn::TFromD<D>;
  constexpr Real pi = Real(3.14159265358979323846);
  const V along = hn::Abs(c), across = hn::Abs(s);
  const V within_octant = hn::Atan(d, hn::Div(hn::Min(along, across), hn::Max(along, across)));
  const V within_quadrant = hn::IfThenElse(hn::Gt(across, along),
                                           hn::Sub(hn::Set(d, Real(0.5) * pi), within_octant), within_octant);
  const V half_turn =
      hn::IfThenElse(hn::Lt(c, hn::Zero(d)), hn::Sub(hn::Set(d, pi), within_quadrant), within_quadrant);
  return hn::CopySign(half_turn, s);
}

template <class V>
HWY_INLINE Vector3<V> only_where(hn::Mask<hn::DFromV<V>> mask, const Vector3<V>& a) {
  return {hn::IfThenElseZero(mask, a.x), hn::IfThenElseZero(mask, a.y), hn::IfThenElseZero(mask, a.z)};
}

/// A hinge in each lane, with the edge from corner 0 to corner 1 and the normals as long as the heights of
/// the triangles over it. The gradient of its angle (Bridson, Marino, Fedkiw 2003) is -n / n^2 at the corner
/// opposite; the ends of the edge get the opposite of it, each the more, the nearer the foot of the height.
template <class V>
struct LaneHinge {
  Vector3<V> side, other_side, along, normal, other_normal;
  V length, inverse_square, other_inverse_square;
  V share, other_share;                 ///< where the feet of the heights lie: 0 at corner 0, 1 at corner 1
  Vector3<V> gradient, other_gradient;  ///< at the corners 2 and 3
  hn::Mask<hn::DFromV<V>> there;        ///< whether both triangles have area

  template <class D>
  HWY_INLINE LaneHinge(D d, const Vector3<V>* x) {
    using Real = hn::TFromD<D>;
    const Vector3<V> edge = x[1] - x[0];
    side = x[2] - x[0];
    other_side = x[3] - x[0];
    const V square_length = dot(edge, edge), one = hn::Set(d, Real(1));
    length = hn::Sqrt(square_length);
    const V inverse_length = hn::Div(one, length);
    along = scaled(inverse_length, edge);
    normal = cross(along, side);
    other_normal = cross(other_side, along);
    const V square = dot(normal, normal), other_square = dot(other_normal, other_normal);
    inverse_square = hn::Div(one, square);
    other_inverse_square = hn::Div(one, other_square);
    share = hn::Mul(inverse_length, dot(along, side));
    other_share = hn::Mul(inverse_length, dot(along, other_side));
    gradient = scaled(hn::Neg(inverse_square), normal);
    other_gradient = scaled(hn::Neg(other_inverse_square), other_normal);

    constexpr Real rounding =
        Real(16) * std::numeric_limits<Real>::epsilon() * std::numeric_limits<Real>::epsilon();
    const auto area = [&](V height, const Vector3<V>& s) HWY_ATTR {
      const V least =
          hn::MulAdd(hn::Set(d, rounding), dot(s, s), hn::Set(d, std::numeric_limits<Real>::min()));
      return hn::Gt(height, least);
    };
    there = hn::And(hn::Gt(square_length, hn::Set(d, std::numeric_limits<Real>::min())),
                    hn::And(area(square, side), area(other_square, other_side)));
  }

  /// The angle less the one whose cosine and sine are given, from -pi to pi.
  template <class D>
  HWY_INLINE V angle_from(D d, V cosine, V sine) const {
    const V s = hn::Neg(dot(side, other_normal)), c = dot(normal, other_normal);
    return angle_of(d, hn::MulSub(s, cosine, hn::Mul(c, sine)), hn::MulAdd(c, cosine, hn::Mul(s, sine)));
  }

  /// How fast the angle grows where the corners move so.
  HWY_INLINE V rate(const Vector3<V>* v) const {
    const Vector3<V> edge = v[1] - v[0];
    return hn::Add(dot(gradient, (v[2] - v[0]) - scaled(share, edge)),
                   dot(other_gradient, (v[3] - v[0]) - scaled(other_share, edge)));
  }

  /// Of the angle, at a corner.
  template <std::size_t role, class D>
  HWY_INLINE Vector3<V> gradient_at(D d) const {
    return at_corner<role>(d, gradient, other_gradient);
  }

  /// How fast the gradient at a corner changes where the corners move so: the second derivative of the angle
  /// times v.
  template <std::size_t role, class D>
  HWY_INLINE Vector3<V> gradient_rate_at(D d, const Vector3<V>* v) const {
    const V inverse_length = hn::Div(hn::Set(d, hn::TFromD<D>(1)), length);
    const Vector3<V> edge = v[1] - v[0], side_rate = v[2] - v[0], other_rate = v[3] - v[0];
    const V stretching = hn::Mul(inverse_length, dot(along, edge));
    const Vector3<V> turn = scaled(inverse_length, edge) - scaled(stretching, along);
    const Vector3<V> first =
        gradient_rate(cross(turn, side) + cross(along, side_rate), normal, gradient, inverse_square);
    const Vector3<V> second = gradient_rate(cross(other_side, turn) + cross(other_rate, along), other_normal,
                                            other_gradient, other_inverse_square);
    if constexpr (role == 2) return first;
    if constexpr (role == 3) return second;
    const auto share_rate = [&](const Vector3<V>& s, const Vector3<V>& moving, V foot) HWY_ATTR {
      return hn::NegMulAdd(foot, stretching,
                           hn::Mul(inverse_length, hn::Add(dot(along, moving), dot(turn, s))));
    };
    const Vector3<V> moved = scaled(share_rate(side, side_rate, share), gradient) +
                             scaled(share_rate(other_side, other_rate, other_share), other_gradient);
    const Vector3<V> rest = at_corner<role>(d, first, second);
    return role == 0 ? rest + moved : rest - moved;
  }

 private:
  /// What a corner gets of values at the corners 2 and 3, so that the sum over all corners is zero, and that
  /// of moments too.
  template <std::size_t role, class D>
  HWY_INLINE Vector3<V> at_corner(D d, const Vector3<V>& first, const Vector3<V>& second) const {
    if constexpr (role == 2) return first;
    if constexpr (role == 3) return second;
    const V one = hn::Set(d, hn::TFromD<D>(1));
    const V a = role == 1 ? share : hn::Sub(one, share),
            b = role == 1 ? other_share : hn::Sub(one, other_share);
    return scaled(hn::Neg(a), first) - scaled(b, second);
  }

  /// Of g = -n / n^2.
  static HWY_INLINE Vector3<V> gradient_rate(const Vector3<V>& normal_rate, const Vector3<V>& normal,
                                             const Vector3<V>& gradient, V inverse_square) {
    const V turning = hn::Mul(hn::Add(inverse_square, inverse_square), dot(normal, normal_rate));
    return scaled(hn::Neg(inverse_square), normal_rate) - scaled(turning, gradient);
  }
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#endif
