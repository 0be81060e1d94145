// Springs as elements of two particles, for the kernels of effects. Included anew for each instruction set.
#if defined(HOOKE_AXIAL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HOOKE_AXIAL_INL_H
#undef HOOKE_AXIAL_INL_H
#else
#define HOOKE_AXIAL_INL_H
#endif

#include "kernels/elements-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

/// Where a spring points and how long it is.
template <class V>
struct Axis {
  Vector3<V> along;  ///< unit vector from the second end to the first; zero where they meet
  V length, inverse_length;
};

template <class D, class Element>
HWY_INLINE auto axis_of(D d, const Element& e) {
  using V = hn::Vec<D>;
  const Vector3<V> apart = e.x[0] - e.x[1];
  const V length = hn::Sqrt(dot(apart, apart)), one = hn::Set(d, hn::TFromD<D>(1));
  const V inverse = hn::IfThenElseZero(hn::Gt(length, hn::Zero(d)), hn::Div(one, length));
  return Axis<V>{scaled(inverse, apart), length, inverse};
}

/// The force of a tension on the end `role`.
template <std::size_t role, class D, class V>
HWY_INLINE Vector3<V> pull(D, V tension, const Axis<V>& axis) {
  return scaled(role == 0 ? hn::Neg(tension) : tension, axis.along);
}

/// The product of a derivative, of these sizes along the spring and across it, with a direction.
template <std::size_t role, class D, class V, class Element>
HWY_INLINE Vector3<V> axial_product(D, V along, V across, const Axis<V>& axis, const Element& e) {
  const Vector3<V> moved = role == 0 ? e.v[0] - e.v[1] : e.v[1] - e.v[0];
  const V most = hn::Mul(hn::Sub(along, across), dot(axis.along, moved));
  return scaled(across, moved) + scaled(most, axis.along);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#endif
