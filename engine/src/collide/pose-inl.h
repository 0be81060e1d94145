// From the world to the frame of a pose and back, a vector of points at a time. Included once for each
// instruction set, after hwy/foreach_target.h.

#if defined(HOOKE_POSE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HOOKE_POSE_INL
#undef HOOKE_POSE_INL
#else
#define HOOKE_POSE_INL
#endif

#include "collide/contact.h"
#include "kernels/elements-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

template <class D, class Real>
HWY_INLINE auto set3(D d, const Real* a) {
  return Vector3<hn::Vec<D>>{hn::Set(d, a[0]), hn::Set(d, a[1]), hn::Set(d, a[2])};
}

/// The vector in the frame of a pose: transposed rotation.
template <class D, class Real, class V = hn::Vec<D>>
HWY_INLINE Vector3<V> turned_back(D d, const Pose<Real>& pose, const Vector3<V>& a) {
  const auto& r = pose.rotation;
  const auto row = [&](std::size_t i) HWY_ATTR {
    return hn::MulAdd(hn::Set(d, r[0][i]), a.x,
                      hn::MulAdd(hn::Set(d, r[1][i]), a.y, hn::Mul(hn::Set(d, r[2][i]), a.z)));
  };
  return {row(0), row(1), row(2)};
}

template <class D, class Real, class V = hn::Vec<D>>
HWY_INLINE Vector3<V> turned(D d, const Pose<Real>& pose, const Vector3<V>& a) {
  const auto& r = pose.rotation;
  const auto row = [&](std::size_t i) HWY_ATTR {
    return hn::MulAdd(hn::Set(d, r[i][0]), a.x,
                      hn::MulAdd(hn::Set(d, r[i][1]), a.y, hn::Mul(hn::Set(d, r[i][2]), a.z)));
  };
  return {row(0), row(1), row(2)};
}

template <class D, class Real, class V = hn::Vec<D>>
HWY_INLINE Vector3<V> to_local(D d, const Pose<Real>& pose, const Vector3<V>& x) {
  return turned_back(d, pose, x - set3(d, pose.origin));
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#endif
