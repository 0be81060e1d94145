// Included once for each instruction set, after hwy/foreach_target.h.

#if defined(HOOKE_ELEMENTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HOOKE_ELEMENTS_INL
#undef HOOKE_ELEMENTS_INL
#else
#define HOOKE_ELEMENTS_INL
#endif

#include <hwy/highway.h>

#include "model/element_slots.h"
#include "strip.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// A vector in space for each lane.
template <class V>
struct Vector3 {
  V x, y, z;
};

template <class V>
HWY_INLINE Vector3<V> operator-(const Vector3<V>& a, const Vector3<V>& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

template <class V>
HWY_INLINE Vector3<V> operator+(const Vector3<V>& a, const Vector3<V>& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}

template <class V>
HWY_INLINE Vector3<V> scaled(V s, const Vector3<V>& a) {
  return {hn::Mul(s, a.x), hn::Mul(s, a.y), hn::Mul(s, a.z)};
}

template <class V>
HWY_INLINE V dot(const Vector3<V>& a, const Vector3<V>& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

template <class V>
HWY_INLINE Vector3<V> cross(const Vector3<V>& a, const Vector3<V>& b) {
  return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
          hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}

/// An element in each lane: its corners' positions, their velocities or a direction, its coefficients.
template <class V, std::size_t corners, std::size_t coefficients>
struct LaneElements {
  Vector3<V> x[corners], v[corners];
  V c[coefficients];
};

/// The arrays of a state, one vector for each lane of them.
template <class D, class Real>
HWY_INLINE Vector3<hn::Vec<D>> load_vectors(D d, const Real* x, const Real* y, const Real* z,
                                            std::ptrdiff_t place) {
  return {hn::LoadU(d, x + place), hn::LoadU(d, y + place), hn::LoadU(d, z + place)};
}

template <class D, class Real, class I>
HWY_INLINE Vector3<hn::Vec<D>> gather_vectors(D d, const Real* x, const Real* y, const Real* z, I place) {
  return {hn::GatherIndex(d, x, place), hn::GatherIndex(d, y, place), hn::GatherIndex(d, z, place)};
}

/// Calls visit(std::integral_constant<std::size_t, role>) for the role that is given.
template <std::size_t corners, class Visit>
HWY_INLINE void with_role(std::uint32_t role, const Visit& visit) {
  static_assert(corners <= most_corners);
  if (role == 0) return visit(std::integral_constant<std::size_t, 0>{});
  if constexpr (corners > 1) {
    if (role == 1) return visit(std::integral_constant<std::size_t, 1>{});
  }
  if constexpr (corners > 2) {
    if (role == 2) return visit(std::integral_constant<std::size_t, 2>{});
  }
  if constexpr (corners > 3) visit(std::integral_constant<std::size_t, 3>{});
}

/// Calls visit(d, element, slot, lane) for vectors of a block's elements in one slot; `lane` counts within
/// the block. Velocities are loaded only where `velocities`.
template <std::size_t corners, std::size_t coefficients, bool velocities, class Real, class Visit>
HWY_INLINE void for_each_lane_element(const ElementSlots<Real>& slots,
                                      const typename ElementSlots<Real>::Slot& slot, const State<Real>& state,
                                      std::size_t block, const Visit& visit) {
  const hn::CappedTag<Real, block_size> d;
  const hn::RebindToSigned<decltype(d)> di;
  using V = hn::Vec<decltype(d)>;
  for (std::size_t lane = 0; lane < block_size; lane += hn::Lanes(d)) {
    LaneElements<V, corners, coefficients> element;
    const auto own = std::ptrdiff_t(block * block_size + lane);
    for (std::size_t c = 0; c < corners; ++c) {
      if (slot.indexed()) {
        const auto place = hn::LoadU(di, slots.particle_row(slot, c) + lane);
        element.x[c] = gather_vectors(d, state.x(), state.y(), state.z(), place);
        if constexpr (velocities) element.v[c] = gather_vectors(d, state.vx(), state.vy(), state.vz(), place);
      } else {
        const std::ptrdiff_t place = own + slot.shift[c];
        element.x[c] = load_vectors(d, state.x(), state.y(), state.z(), place);
        if constexpr (velocities) element.v[c] = load_vectors(d, state.vx(), state.vy(), state.vz(), place);
      }
    }
    for (std::size_t k = 0; k < coefficients; ++k)
      element.c[k] = hn::LoadU(d, slots.value_row(slot, k) + lane);
    visit(d, element, lane);
  }
}

/// The numbers of the elements in lanes, of slots that keep them.
template <class D, class Real>
HWY_INLINE auto element_numbers(D, const ElementSlots<Real>& slots,
                                const typename ElementSlots<Real>::Slot& slot, std::size_t lane) {
  return hn::LoadU(hn::RebindToSigned<D>(), slots.element_row(slot) + lane);
}

/// The force of a law on the corner `role` of each element. A law with a `memory`, of one value for each
/// element, is given those of the elements.
template <std::size_t role, class D, class Law, class Real, class Element>
HWY_INLINE auto force_on(D d, const Law& law, const ElementSlots<Real>& slots,
                         const typename ElementSlots<Real>::Slot& slot, const Element& element,
                         std::size_t lane) {
  if constexpr (requires { law.memory; }) {
    const auto number = element_numbers(d, slots, slot, lane);
    return law.template force<role>(d, element, hn::GatherIndex(d, law.memory, number));
  } else {
    return law.template force<role>(d, element);
  }
}

/// Adds law.template force<role>(d, element), the force on the corner `role` of each element, to the
/// particles of a strip. A Law has `corners`, `coefficients` and `velocities`. Lanes whose first coefficient
/// is zero get nothing, whatever the law makes of them.
template <class Law, class Real>
HWY_INLINE void add_element_forces(const ElementSlots<Real>& slots, const Strip<Real>& strip, const Law& law,
                                   StripForce<Real>& force) {
  const std::size_t first_block = strip.first / block_size;
  for (std::size_t b = 0; b < strip.lanes / block_size; ++b) {
    const std::size_t block = first_block + b;
    const auto& list = slots.list(block);
    for (std::uint32_t s = list.begin; s < list.end; ++s) {
      const auto& slot = slots.slots[s];
      with_role<Law::corners>(slot.role, [&](auto role) HWY_ATTR {
        for_each_lane_element<Law::corners, Law::coefficients, Law::velocities>(
            slots, slot, strip.state, block, [&](auto d, const auto& element, std::size_t lane) HWY_ATTR {
              const auto f = force_on<decltype(role)::value>(d, law, slots, slot, element, lane);
              const auto there = hn::Ne(element.c[0], hn::Zero(d));
              const auto add = [&](auto value, Real* sum) HWY_ATTR {
                hn::Store(hn::Add(hn::Load(d, sum), hn::IfThenElseZero(there, value)), d, sum);
              };
              const std::size_t place = b * block_size + lane;
              add(f.x, force.x + place);
              add(f.y, force.y + place);
              add(f.z, force.z + place);
            });
      });
    }
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#endif
