// Distances to shapes, a vector of points at a time. Included once for each instruction set, after
// hwy/foreach_target.h.

#if defined(HOOKE_SHAPES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HOOKE_SHAPES_INL
#undef HOOKE_SHAPES_INL
#else
#define HOOKE_SHAPES_INL
#endif

#include <bit>

#include "collide/local_shape.h"
#include "effects/lanes-inl.h"
#include "kernels/elements-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

/// Of a shape's surface, as seen from points in its frame.
template <class V>
struct Surface {
  V distance;           ///< negative inside
  Vector3<V> outwards;  ///< unit vector away from the nearest point of the surface, out of the solid
};

template <class D, class Real, class V = hn::Vec<D>>
HWY_INLINE Surface<V> surface_at(D d, const LocalPlane<Real>& plane, const Vector3<V>& p) {
  const Vector3<V> normal{hn::Set(d, plane.nx), hn::Set(d, plane.ny), hn::Set(d, plane.nz)};
  return {hn::Sub(dot(normal, p), hn::Set(d, plane.height)), normal};
}

/// Around a point or a line that is `away` from the points, by a radius.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Surface<V> round_surface(D d, const Vector3<V>& away, const Vector3<V>& where_none, V radius) {
  const V length = hn::Sqrt(dot(away, away));
  const auto is_away = hn::Gt(length, hn::Zero(d));
  const V inverse = hn::Div(hn::Set(d, hn::TFromD<D>(1)), length);
  const auto along = [&](V a, V other)
                         HWY_ATTR { return hn::IfThenElse(is_away, hn::Mul(a, inverse), other); };
  return {hn::Sub(length, radius),
          {along(away.x, where_none.x), along(away.y, where_none.y), along(away.z, where_none.z)}};
}

template <class D, class Real, class V = hn::Vec<D>>
HWY_INLINE Surface<V> surface_at(D d, const LocalSphere<Real>& sphere, const Vector3<V>& p) {
  const Vector3<V> up{hn::Zero(d), hn::Set(d, Real(1)), hn::Zero(d)};
  return round_surface(d, p, up, hn::Set(d, sphere.radius));
}

template <class D, class Real, class V = hn::Vec<D>>
HWY_INLINE Surface<V> surface_at(D d, const LocalCapsule<Real>& capsule, const Vector3<V>& p) {
  const Vector3<V> half{hn::Set(d, capsule.ex), hn::Set(d, capsule.ey), hn::Set(d, capsule.ez)};
  const V one = hn::Set(d, Real(1));
  const V place = hn::Mul(dot(p, half), hn::Set(d, capsule.inverse_square));
  const V on_line = hn::Max(hn::Neg(one), hn::Min(place, one));
  const Vector3<V> aside{hn::Set(d, capsule.aside_x), hn::Set(d, capsule.aside_y),
                         hn::Set(d, capsule.aside_z)};
  return round_surface(d, p - scaled(on_line, half), aside, hn::Set(d, capsule.radius));
}

template <class D, class Real, class V = hn::Vec<D>>
HWY_INLINE Surface<V> surface_at(D d, const LocalBox<Real>& box, const Vector3<V>& p) {
  const V zero = hn::Zero(d), one = hn::Set(d, Real(1));
  const Vector3<V> beyond{hn::Sub(hn::Abs(p.x), hn::Set(d, box.hx)),
                          hn::Sub(hn::Abs(p.y), hn::Set(d, box.hy)),
                          hn::Sub(hn::Abs(p.z), hn::Set(d, box.hz))};
  const V deepest = hn::Max(beyond.x, hn::Max(beyond.y, beyond.z));
  const auto is_outside = hn::Gt(deepest, zero);
  const Vector3<V> out{hn::Max(beyond.x, zero), hn::Max(beyond.y, zero), hn::Max(beyond.z, zero)};
  const V length = hn::Sqrt(dot(out, out)), inverse = hn::Div(one, length);
  // Inside, the way to the nearest side: the first of those that are equally near.
  const auto by_x = hn::Ge(beyond.x, hn::Max(beyond.y, beyond.z));
  const auto by_y = hn::AndNot(by_x, hn::Ge(beyond.y, beyond.z));
  const auto by_z = hn::Not(hn::Or(by_x, by_y));
  const auto along = [&](V a, V coordinate, auto is_nearest) HWY_ATTR {
    const V size = hn::IfThenElse(is_outside, hn::Mul(a, inverse), hn::IfThenElseZero(is_nearest, one));
    return hn::CopySign(size, coordinate);
  };
  return {hn::IfThenElse(is_outside, length, deepest),
          {along(out.x, p.x, by_x), along(out.y, p.y, by_y), along(out.z, p.z, by_z)}};
}

/// One point after the other: each looks at triangles of its own.
template <class D, class Distances, class V = hn::Vec<D>>
HWY_INLINE Surface<V> surface_at(D d, const LookedUpShape<Distances>& shape, const Vector3<V>& p) {
  using Real = hn::TFromD<D>;
  alignas(cache_line) Real x[block_size], y[block_size], z[block_size], distance[block_size];
  hn::Store(p.x, d, x), hn::Store(p.y, d, y), hn::Store(p.z, d, z);
  for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
    const typename Distances::Vector point(x[lane], y[lane], z[lane]);
    const SeenSurface<Real> seen = shape.distances->from(point);
    distance[lane] = seen.distance(point);
    x[lane] = seen.outwards.x(), y[lane] = seen.outwards.y(), z[lane] = seen.outwards.z();
  }
  return {hn::Load(d, distance), {hn::Load(d, x), hn::Load(d, y), hn::Load(d, z)}};
}

/// The same for the particles of a block from a lane on, of those that count.
template <class D, class Shape, class V = hn::Vec<D>>
HWY_INLINE Surface<V> surface_again(D d, const Shape& shape, const Vector3<V>& p, hn::Mask<D>, std::size_t,
                                    std::size_t) {
  return surface_at(d, shape, p);
}

/// Only of points that have left the place where the plane holds that they saw, a new one is looked for.
template <class D, class Distances, class V = hn::Vec<D>>
HWY_INLINE Surface<V> surface_again(D d, const LookedUpShape<Distances>& shape, const Vector3<V>& p,
                                    hn::Mask<D> counts, std::size_t block, std::size_t lane) {
  using Real = hn::TFromD<D>;
  SeenPlanes<Real>& seen = (*shape.seen)[block];
  const auto load = [&](const Real* values) HWY_ATTR { return hn::Load(d, values + lane); };
  const Vector3<V> moved = p - Vector3<V>{load(seen.x), load(seen.y), load(seen.z)};
  const auto left = hn::AndNot(hn::Lt(dot(moved, moved), load(seen.square_within)), counts);
  if (!hn::AllFalse(d, left)) {
    alignas(cache_line) Real x[block_size], y[block_size], z[block_size];
    hn::Store(p.x, d, x), hn::Store(p.y, d, y), hn::Store(p.z, d, z);
    std::uint32_t bits = bits_of(d, left);
    for (; bits != 0; bits &= bits - 1) {
      const auto i = std::size_t(std::countr_zero(bits));
      const typename Distances::Vector point(x[i], y[i], z[i]);
      seen.set(lane + i, point, shape.distances->from(point));
    }
  }
  const Vector3<V> outwards{load(seen.nx), load(seen.ny), load(seen.nz)};
  return {hn::Sub(dot(outwards, p), load(seen.offset)), outwards};
}

/// How far a point is from a surface, well enough to get there in a few steps as long as that.
template <class D, class Shape, class V = hn::Vec<D>>
HWY_INLINE hn::TFromD<D> way_to(D d, const Shape& shape, const Vector3<V>& p) {
  return hn::GetLane(surface_at(d, shape, p).distance);
}

template <class D, class Distances, class V = hn::Vec<D>>
HWY_INLINE hn::TFromD<D> way_to(D, const LookedUpShape<Distances>& shape, const Vector3<V>& p) {
  return shape.distances->exactly({hn::GetLane(p.x), hn::GetLane(p.y), hn::GetLane(p.z)});
}

/// Calls visit(shape) for what a shape is.
template <class Real, class Visit>
HWY_INLINE auto with_shape(const LocalShape<Real>& shape, const Visit& visit) {
  if (const auto* plane = std::get_if<LocalPlane<Real>>(&shape)) return visit(*plane);
  if (const auto* sphere = std::get_if<LocalSphere<Real>>(&shape)) return visit(*sphere);
  if (const auto* capsule = std::get_if<LocalCapsule<Real>>(&shape)) return visit(*capsule);
  if (const auto* box = std::get_if<LocalBox<Real>>(&shape)) return visit(*box);
  if (const auto* mesh = std::get_if<LookedUpShape<MeshDistance<Real>>>(&shape)) return visit(*mesh);
  return visit(*std::get_if<LookedUpShape<HeightDistance<Real>>>(&shape));
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#endif
