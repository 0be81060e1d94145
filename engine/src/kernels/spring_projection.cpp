#include "kernels/spring_projection.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/spring_projection.cpp"
#include <hwy/foreach_target.h>

#include "kernels/flush_subnormals.h"
#include "kernels/packed-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

/// Writes a packed vector for each lane to its own place.
template <class D, class V = hn::Vec<D>, class Real = hn::TFromD<D>>
HWY_INLINE void store_packed4(D d, const Vector4<V>& vectors, Real* packed, const std::int32_t* offsets) {
  HWY_ALIGN Real lanes[packed_width * hn::MaxLanes(D())];
#if HWY_TARGET == HWY_SCALAR
  hn::Store(vectors.xyz.x, d, lanes);
  hn::Store(vectors.xyz.y, d, lanes + 1);
  hn::Store(vectors.xyz.z, d, lanes + 2);
  hn::Store(vectors.w, d, lanes + 3);
#else
  hn::StoreInterleaved4(vectors.xyz.x, vectors.xyz.y, vectors.xyz.z, vectors.w, d, lanes);
#endif
  for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
    const Real* const from = lanes + lane * packed_width;
    std::copy(from, from + packed_width, at_offset(packed, offsets[lane]));
  }
}

template <class V>
HWY_INLINE Vector3<V> moved(const Vector3<V>& from, V by, const Vector3<V>& along) {
  return {hn::MulAdd(by, along.x, from.x), hn::MulAdd(by, along.y, from.y), hn::MulAdd(by, along.z, from.z)};
}

template <class Real, bool damped>
class Projection {
 public:
  using D = hn::CappedTag<Real, block_size>;
  using V = hn::Vec<D>;

  Projection(const SpringGroups<Real>& groups, Real h, const ProjectedParticles<Real>& particles)
      : groups_(groups), particles_(particles), h_(h) {}

  /// The springs from `spring` on. `multipliers` is null or theirs.
  HWY_INLINE void project(std::size_t spring, Real* multipliers) const {
    const D d;
    const std::int32_t *const first = groups_.first.data() + spring, *const second =
                                                                         groups_.second.data() + spring;
    const Vector4<V> a = load_packed4(d, particles_.places, first);
    const Vector4<V> b = load_packed4(d, particles_.places, second);
    Vector4<V> move_a = load_packed4(d, particles_.moves, first);
    Vector4<V> move_b = load_packed4(d, particles_.moves, second);
    const Vector3<V> apart = (a.xyz - b.xyz) - (move_b.xyz - move_a.xyz);
    const V tiny = hn::Set(d, std::numeric_limits<Real>::min());
    const V square =
        hn::MulAdd(apart.x, apart.x, hn::MulAdd(apart.y, apart.y, hn::MulAdd(apart.z, apart.z, tiny)));
    const TwiceReciprocalRoot<V> root = twice_reciprocal_root(d, square);
    const V inverse = hn::Mul(hn::Mul(hn::Set(d, Real(0.5)), root.estimate), root.correction);
    const V known = multipliers == nullptr ? hn::Zero(d) : hn::Load(d, multipliers);
    const V change = hn::IfThenElseZero(hn::Gt(square, tiny),
                                        change_of_multiplier(spring, square, inverse, known, a, b, apart));
    if (multipliers != nullptr) hn::Store(hn::Add(known, change), d, multipliers);
    const V push = hn::Mul(change, inverse);
    move_a.xyz = moved(move_a.xyz, hn::Mul(a.w, push), apart);
    move_b.xyz = moved(move_b.xyz, hn::Neg(hn::Mul(b.w, push)), apart);
    store_packed4(d, move_a, particles_.moves, first);
    store_packed4(d, move_b, particles_.moves, second);
  }

 private:
  HWY_INLINE V change_of_multiplier(std::size_t spring, V square, V inverse, V known, const Vector4<V>& a,
                                    const Vector4<V>& b, const Vector3<V>& apart) const {
    const D d;
    const V h = hn::Set(d, h_);
    const V strength = hn::Mul(hn::Mul(h, h), hn::Load(d, groups_.stiffness.data() + spring));
    const V longer = hn::MulSub(square, inverse, hn::Load(d, groups_.rest_length.data() + spring));
    V lacking = hn::MulAdd(strength, longer, known), resistance = strength;
    if constexpr (damped) {
      const V drag = hn::Mul(h, hn::Load(d, groups_.damping.data() + spring));
      const Vector3<V> before = load_packed(d, particles_.before, groups_.first.data() + spring) -
                                load_packed(d, particles_.before, groups_.second.data() + spring);
      lacking = hn::MulAdd(drag, hn::Mul(inverse, dot(apart - before, apart)), lacking);
      resistance = hn::Add(strength, drag);
    }
    const V one = hn::Set(d, Real(1));
    return hn::Neg(hn::Div(lacking, hn::MulAdd(resistance, hn::Add(a.w, b.w), one)));
  }

  const SpringGroups<Real>& groups_;
  const ProjectedParticles<Real>& particles_;
  Real h_;
};

template <bool damped, class Real>
HWY_INLINE void project_all(const SpringGroups<Real>& groups, std::size_t begin, std::size_t end, Real h,
                            const ProjectedParticles<Real>& particles, Real* multipliers) {
  const Projection<Real, damped> projection(groups, h, particles);
  const typename Projection<Real, damped>::D d;
  for (std::size_t spring = begin * block_size; spring < end * block_size; spring += hn::Lanes(d))
    projection.project(spring, multipliers == nullptr ? nullptr : multipliers + spring);
}

template <class Real>
HWY_INLINE void project_groups(const SpringGroups<Real>& groups, std::size_t begin, std::size_t end, Real h,
                               const ProjectedParticles<Real>& particles, Real* multipliers) {
  const FlushSubnormals flush;
  groups.damping.empty() ? project_all<false>(groups, begin, end, h, particles, multipliers)
                         : project_all<true>(groups, begin, end, h, particles, multipliers);
}

}  // namespace

void project_float(const SpringGroups<float>& groups, std::size_t begin, std::size_t end, float h,
                   const ProjectedParticles<float>& particles, float* multipliers) {
  project_groups(groups, begin, end, h, particles, multipliers);
}

void project_double(const SpringGroups<double>& groups, std::size_t begin, std::size_t end, double h,
                    const ProjectedParticles<double>& particles, double* multipliers) {
  project_groups(groups, begin, end, h, particles, multipliers);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {
namespace {

HWY_EXPORT(project_float);
HWY_EXPORT(project_double);

}  // namespace

template <>
void project_springs(const SpringGroups<float>& groups, std::size_t begin, std::size_t end, float h,
                     const ProjectedParticles<float>& particles, float* multipliers) {
  HWY_DYNAMIC_DISPATCH(project_float)(groups, begin, end, h, particles, multipliers);
}

template <>
void project_springs(const SpringGroups<double>& groups, std::size_t begin, std::size_t end, double h,
                     const ProjectedParticles<double>& particles, double* multipliers) {
  HWY_DYNAMIC_DISPATCH(project_double)(groups, begin, end, h, particles, multipliers);
}

}  // namespace hooke
#endif
