#include "collide/contact.h"

#include "state.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collide/contact.cpp"
#include <hwy/foreach_target.h>

#include "collide/pose-inl.h"
#include "collide/shapes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

/// How far along the way from p to q, from 0 to 1, a particle first comes to a distance from the surface; 1
/// or more where it does not. From further away, by steps as long as what is left: it never goes past.
template <class Shape, class Real>
HWY_INLINE Real first_touch(const Shape& shape, Real distance, Real near, const Real* p, const Real* q) {
  const hn::CappedTag<Real, 1> d;
  constexpr int most_steps = 64;  // grazing ones are stopped where they are nearest
  const auto from = set3(d, p), way = set3(d, q) - from;
  const Real length = hn::GetLane(hn::Sqrt(dot(way, way)));
  Real t = Real(0);
  for (int i = 0; i < most_steps && t < Real(1); ++i) {
    const auto place = from + scaled(hn::Set(d, t), way);
    const Real gap = way_to(d, shape, place) - distance;
    if (gap <= near) return t;
    t += gap / length;
  }
  return t;
}

/// Moves points that have got in, or through, to where they came in first. Returns the mask of these.
template <class D, class Shape, class Real, class V = hn::Vec<D>>
HWY_INLINE std::uint32_t stop_at_entry(D d, const Shape& shape, Real distance, Real near, std::uint32_t lanes,
                                       const Vector3<V>& start, Vector3<V>& end) {
  alignas(cache_line) Real p[3][block_size], q[3][block_size];
  hn::Store(start.x, d, p[0]), hn::Store(start.y, d, p[1]), hn::Store(start.z, d, p[2]);
  hn::Store(end.x, d, q[0]), hn::Store(end.y, d, q[1]), hn::Store(end.z, d, q[2]);
  std::uint32_t stopped = 0;
  for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
    if ((lanes >> lane & 1u) == 0) continue;
    const Real from[] = {p[0][lane], p[1][lane], p[2][lane]}, to[] = {q[0][lane], q[1][lane], q[2][lane]};
    const Real t = first_touch(shape, distance, near, from, to);
    if (!(t < Real(1))) continue;
    for (std::size_t k = 0; k < 3; ++k) q[k][lane] = from[k] + t * (to[k] - from[k]);
    stopped |= 1u << lane;
  }
  end = {hn::Load(d, q[0]), hn::Load(d, q[1]), hn::Load(d, q[2])};
  return stopped;
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> are_finite(D, const Vector3<V>& a) {
  return hn::And(hn::IsFinite(a.x), hn::And(hn::IsFinite(a.y), hn::IsFinite(a.z)));
}

/// What a contact does to the velocity against the surface.
template <class V>
struct VelocityChange {
  Vector3<V> change;
  V share;  ///< that friction takes of the velocity along the surface [1]
};

/// Coulomb's law: what the surface takes of the velocity along it is at most `friction` times the change
/// across it.
template <class D, class Real, class V = hn::Vec<D>>
HWY_INLINE VelocityChange<V> velocity_change(D d, const Contact<Real>& contact, const Vector3<V>& against,
                                             const Vector3<V>& outwards) {
  const V zero = hn::Zero(d), one = hn::Set(d, Real(1));
  const V normal = dot(against, outwards);
  const V change = hn::Mul(hn::Max(hn::Neg(normal), zero), hn::Set(d, Real(1) + contact.restitution));
  const Vector3<V> along = against - scaled(normal, outwards);
  const V speed = hn::Sqrt(dot(along, along));
  const V most = hn::Mul(hn::Set(d, contact.friction), change);
  const V share = hn::IfThenElseZero(hn::Gt(speed, zero), hn::Min(hn::Div(most, speed), one));
  return {scaled(change, outwards) - scaled(share, along), share};
}

/// How a contact moves a particle from p. What friction takes of the velocity it takes of the way along the
/// surface in this step, too, at most `friction` times the depth: so what sticks stays, also by methods whose
/// way is not the velocity at the end times the step.
template <class D, class Real, class V = hn::Vec<D>>
HWY_INLINE Vector3<V> move_of(D d, const Contact<Real>& contact, const ContactBlock<Real>& block,
                              std::size_t lane, const Vector3<V>& p, const Surface<V>& surface, V share) {
  const Vector3<V> start{hn::Load(d, block.x0 + lane), hn::Load(d, block.y0 + lane),
                         hn::Load(d, block.z0 + lane)};
  const Vector3<V> way = p - to_local(d, contact.before, start);
  const Vector3<V> along = way - scaled(dot(way, surface.outwards), surface.outwards);
  const V zero = hn::Zero(d), length = hn::Sqrt(dot(along, along));
  const V depth = hn::Max(hn::Sub(hn::Set(d, contact.thickness), surface.distance), zero);
  const V most = hn::Div(hn::Mul(hn::Set(d, contact.friction), depth), length);
  const V taken = hn::IfThenElseZero(hn::Gt(length, zero), hn::Min(share, most));
  return scaled(depth, surface.outwards) - scaled(taken, along);
}

/// Stops particles that have gone through the solid within the step, or so far in that the nearest surface is
/// not the one that they came through. Returns which. It is told by a layer below the surface, so that what
/// slides on a surface is not taken for what goes through it.
template <class D, class Shape, class Real, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> stop_fast(D d, const Shape& shape, const Contact<Real>& contact,
                                 const ContactBlock<Real>& block, std::size_t lane, hn::Mask<D> is_free,
                                 V gap, Vector3<V>& p) {
  const Real skin = Real(0.05) * shape.inner_radius();
  const V zero = hn::Zero(d);
  const auto above_skin = [&](V gap_there) HWY_ATTR { return hn::Add(gap_there, hn::Set(d, skin)); };
  const auto looked_at = [&](const Vector3<V>& place) HWY_ATTR {
    return above_skin(hn::Sub(surface_at(d, shape, place).distance, hn::Set(d, contact.thickness)));
  };
  V above = above_skin(gap);
  const Vector3<V> start{hn::Load(d, block.x0 + lane), hn::Load(d, block.y0 + lane),
                         hn::Load(d, block.z0 + lane)};
  const Vector3<V> q = to_local(d, contact.before, start), way = p - q;
  const V length = hn::Sqrt(dot(way, way));
  const auto is_deep = hn::Lt(above, hn::Set(d, Real(-0.5) * shape.inner_radius()));
  const auto may_be_through = hn::And(hn::Ge(above, zero), hn::Lt(above, length));
  const auto is_fast = hn::And(is_free, hn::Or(is_deep, may_be_through));
  if (hn::AllFalse(d, is_fast)) return is_fast;
  if constexpr (Shape::is_looked_up) above = looked_at(p);  // what was seen earlier does not decide
  const V above_before = looked_at(q);
  const auto came_in = hn::And(hn::Ge(above_before, zero), hn::Lt(hn::Add(above_before, above), length));
  const auto candidates = hn::And(is_fast, came_in);
  if (hn::AllFalse(d, candidates)) return candidates;
  return mask_of(
      d, stop_at_entry(d, shape, contact.thickness - skin, Real(0.1) * skin, bits_of(d, candidates), q, p));
}

template <class Shape, class Real>
HWY_INLINE std::uint16_t resolve_shape(const Shape& shape, const Contact<Real>& contact,
                                       const ContactBlock<Real>& block) {
  const hn::CappedTag<Real, block_size> d;
  using V = hn::Vec<decltype(d)>;
  const V zero = hn::Zero(d), thickness = hn::Set(d, contact.thickness);
  std::uint16_t touched = 0;
  for (std::size_t lane = 0; lane < block_size; lane += hn::Lanes(d)) {
    const auto is_free = mask_of(d, std::uint32_t(block.free) >> lane);
    const Vector3<V> x{hn::Load(d, block.x + lane), hn::Load(d, block.y + lane), hn::Load(d, block.z + lane)};
    Vector3<V> p = to_local(d, contact.after, x);
    Surface<V> surface = surface_again(d, shape, p, is_free, block.number, lane);
    V gap = hn::Sub(surface.distance, thickness);
    auto touches = hn::And(is_free, hn::Lt(gap, zero));
    if constexpr (Shape::can_be_passed) {
      const auto stopped = stop_fast(d, shape, contact, block, lane, is_free, gap, p);
      if (!hn::AllFalse(d, stopped)) {
        touches = hn::Or(touches, stopped);
        surface = surface_at(d, shape, p);
        gap = hn::Sub(surface.distance, thickness);
      }
    }
    if (hn::AllFalse(d, touches)) continue;
    const Vector3<V> v{hn::Load(d, block.vx + lane), hn::Load(d, block.vy + lane),
                       hn::Load(d, block.vz + lane)};
    const Vector3<V> spinning = cross(set3(d, contact.spin), p);
    const Vector3<V> against = turned_back(d, contact.after, v - set3(d, contact.velocity)) - spinning;
    const auto [change, share] = velocity_change(d, contact, against, surface.outwards);
    const Vector3<V> place = p + move_of(d, contact, block, lane, p, surface, share);
    const Vector3<V> next = turned(d, contact.after, place) + set3(d, contact.after.origin);
    const Vector3<V> velocity = v + turned(d, contact.after, change);
    // Where speeds are so high that their squares overflow, the run has gone bad: it is left to its next step
    // to tell.
    touches = hn::And(touches, hn::And(are_finite(d, next), are_finite(d, velocity)));
    const auto put = [&](V value, Real* values) HWY_ATTR {
      hn::Store(hn::IfThenElse(touches, value, hn::Load(d, values + lane)), d, values + lane);
    };
    put(next.x, block.x), put(next.y, block.y), put(next.z, block.z);
    put(velocity.x, block.vx), put(velocity.y, block.vy), put(velocity.z, block.vz);
    touched = std::uint16_t(touched | bits_of(d, touches) << lane);
  }
  return touched;
}

template <class Real>
HWY_INLINE std::uint16_t resolve_any(const Contact<Real>& contact, const ContactBlock<Real>& block) {
  return with_shape(contact.shape,
                    [&](const auto& shape) HWY_ATTR { return resolve_shape(shape, contact, block); });
}

}  // namespace

std::uint16_t resolve_float(const Contact<float>& contact, const ContactBlock<float>& block) {
  return resolve_any(contact, block);
}

std::uint16_t resolve_double(const Contact<double>& contact, const ContactBlock<double>& block) {
  return resolve_any(contact, block);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {

HWY_EXPORT(resolve_float);
HWY_EXPORT(resolve_double);

std::uint16_t resolve(const Contact<float>& contact, const ContactBlock<float>& block) {
  return HWY_DYNAMIC_DISPATCH(resolve_float)(contact, block);
}

std::uint16_t resolve(const Contact<double>& contact, const ContactBlock<double>& block) {
  return HWY_DYNAMIC_DISPATCH(resolve_double)(contact, block);
}

}  // namespace hooke
#endif
