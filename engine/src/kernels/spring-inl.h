// Included once for each instruction set, after hwy/foreach_target.h.

#if defined(HOOKE_SPRING_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HOOKE_SPRING_INL
#undef HOOKE_SPRING_INL
#else
#define HOOKE_SPRING_INL
#endif

#include <hwy/highway.h>

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// A vector for each coordinate.
template <class V>
struct Vector3 {
  V x, y, z;
};

template <class V>
HWY_INLINE Vector3<V> operator-(const Vector3<V>& a, const Vector3<V>& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

template <class V>
HWY_INLINE V dot(const Vector3<V>& a, const Vector3<V>& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

template <class D>
HWY_INLINE Vector3<hn::Vec<D>> load3(D d, const hn::TFromD<D>* x, const hn::TFromD<D>* y,
                                     const hn::TFromD<D>* z) {
  return {hn::LoadU(d, x), hn::LoadU(d, y), hn::LoadU(d, z)};
}

#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX3
#define HOOKE_ESTIMATES_DOUBLE_ROOTS 1
HWY_INLINE hn::Vec512<double> estimate_reciprocal_root(hn::Vec512<double> a) {
  return hn::Vec512<double>{_mm512_rsqrt14_pd(a.raw)};
}
#else
#define HOOKE_ESTIMATES_DOUBLE_ROOTS 0
#endif

/// 2 / sqrt(a) for a > 0 as a product of two factors, as callers fuse the product with what they do next.
/// Relative error (tests/engine/reciprocal_root_test.cpp): in float at most 3e-7, from an estimate of 12
/// bits, and with AVX-512, which gives 14, 2e-7; in double at most 6e-16.
template <class V>
struct TwiceReciprocalRoot {
  V estimate, correction;
};

/// One Newton step from an estimate y of 1 / sqrt(a) with relative error e: the result's is -1.5 e^2.
template <class D, class V = hn::Vec<D>>
HWY_INLINE TwiceReciprocalRoot<V> newton(D d, V a, V y) {
  return {y, hn::NegMulAdd(hn::Mul(a, y), y, hn::Set(d, hn::TFromD<D>(3)))};
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE TwiceReciprocalRoot<V> twice_reciprocal_root(D d, V a) {
  using Real = hn::TFromD<D>;
  // Other processors' estimates have 8 bits: one of Newton's steps is not enough for them.
  constexpr bool estimates_float = HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128;
  if constexpr (sizeof(Real) == sizeof(float) && estimates_float) {
    return newton(d, a, hn::ApproximateReciprocalSqrt(a));
  } else if constexpr (sizeof(Real) == sizeof(double) && HOOKE_ESTIMATES_DOUBLE_ROOTS) {
#if HOOKE_ESTIMATES_DOUBLE_ROOTS
    // Two of Newton's steps take a third of the time of a root and a division there.
    const TwiceReciprocalRoot<V> first = newton(d, a, estimate_reciprocal_root(a));
    return newton(d, a, hn::Mul(hn::Mul(hn::Set(d, Real(0.5)), first.estimate), first.correction));
#endif
  } else {
    return {hn::Div(hn::Set(d, Real(1)), hn::Sqrt(a)), hn::Set(d, Real(2))};
  }
}

/// Stiffness [N/m], half of stiffness times rest length [N], a quarter of the damping [N s/m]: halved and
/// quartered for the factor 2 in twice_reciprocal_root.
template <class V>
struct SpringRows {
  V stiffness, half_pull, quarter_damping;
};

/// The force of one spring in each lane on the particle that sees the other end at -d = (-dx, -dy, -dz) is
/// -factor times d:
///   F = (k (l - l0) + c (v.n)) n,  n = -d / l   =>   factor = k - k l0 / l + c (v.d) / l^2
/// with v the velocity relative to the other end, like d.
///
/// The smallest normal number is added to l^2, which changes it only where the length is zero or nearly:
/// there the factor stays finite, and d makes the force zero.
///
/// Both ends compute the same bits with opposite sign: every product of d and v keeps its value when both
/// change sign, and sums run in the same order.
template <bool damped, class D, class V = hn::Vec<D>>
HWY_INLINE V spring_factor(D d, const Vector3<V>& apart, const Vector3<V>& velocity,
                           const SpringRows<V>& rows) {
  const V tiny = hn::Set(d, std::numeric_limits<hn::TFromD<D>>::min());
  const V square =
      hn::MulAdd(apart.x, apart.x, hn::MulAdd(apart.y, apart.y, hn::MulAdd(apart.z, apart.z, tiny)));
  const TwiceReciprocalRoot<V> root = twice_reciprocal_root(d, square);
  const V factor = hn::NegMulAdd(hn::Mul(rows.half_pull, root.estimate), root.correction, rows.stiffness);
  if constexpr (!damped) return factor;
  const V twice_inverse = hn::Mul(root.estimate, root.correction);
  const V along = hn::Mul(dot(velocity, apart), twice_inverse);
  return hn::MulAdd(hn::Mul(rows.quarter_damping, along), twice_inverse, factor);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#undef HOOKE_ESTIMATES_DOUBLE_ROOTS
#endif
