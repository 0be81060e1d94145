#include "effects/enclosed_gas.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/enclosed_gas.cpp"
#include <hwy/foreach_target.h>

#include "kernels/elements-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

/// (b - a) x (c - a): twice the area, outwards.
template <class Element>
HWY_INLINE auto double_area(const Element& e) {
  return cross(e.x[1] - e.x[0], e.x[2] - e.x[0]);
}

/// The same force on each corner.
template <class Real>
struct PushLaw {
  static constexpr std::size_t corners = 3, coefficients = 1;
  static constexpr bool velocities = false;
  Real sixth_of_pressure;

  template <std::size_t role, class D, class Element>
  HWY_INLINE auto force(D d, const Element& e) const {
    return scaled(hn::Set(d, sixth_of_pressure), double_area(e));
  }
};

/// The change of double_area() along the direction that stands in place of velocities.
template <class Real>
struct TurnLaw {
  static constexpr std::size_t corners = 3, coefficients = 1;
  static constexpr bool velocities = true;
  Real factor;

  template <std::size_t role, class D, class Element>
  HWY_INLINE auto force(D d, const Element& e) const {
    return scaled(hn::Set(d, factor),
                  cross(e.v[1] - e.v[0], e.x[2] - e.x[0]) + cross(e.x[1] - e.x[0], e.v[2] - e.v[0]));
  }
};

/// Six times the volume between a point and the triangles whose first corner is in the blocks; or six times
/// its change along the direction that stands in place of velocities.
template <bool change, class Real>
HWY_INLINE double six_volumes(const ElementSlots<Real>& slots, const State<Real>& state, const Real* origin,
                              std::size_t begin, std::size_t end) {
  const hn::CappedTag<Real, block_size> tag;
  using V = hn::Vec<decltype(tag)>;
  double total = 0.0;
  for (std::size_t block = begin; block < end; ++block) {
    V sum = hn::Zero(tag);
    const auto& list = slots.list(block);
    for (std::uint32_t s = list.begin; s < list.end; ++s) {
      const auto& slot = slots.slots[s];
      if (slot.role != 0) continue;
      for_each_lane_element<3, 1, change>(
          slots, slot, state, block, [&](auto d, const auto& e, std::size_t) HWY_ATTR {
            const auto normal = double_area(e);
            const auto there = hn::Ne(e.c[0], hn::Zero(d));
            V value;
            if constexpr (change) {
              value = dot(normal, e.v[0] + e.v[1] + e.v[2]);
            } else {
              const Vector3<V> apart = {hn::Set(d, origin[0]), hn::Set(d, origin[1]), hn::Set(d, origin[2])};
              value = dot(normal, e.x[0] - apart);
            }
            sum = hn::Add(sum, hn::IfThenElseZero(there, value));
          });
    }
    HWY_ALIGN Real lanes[block_size] = {};
    hn::Store(sum, tag, lanes);
    for (std::size_t lane = 0; lane < hn::Lanes(tag); ++lane) total += double(lanes[lane]);
  }
  return total;
}

}  // namespace

void push_float(const ElementSlots<float>& slots, const Strip<float>& strip, float factor,
                StripForce<float>& force) {
  add_element_forces(slots, strip, PushLaw<float>{factor}, force);
}

void turn_float(const ElementSlots<float>& slots, const Strip<float>& search, float factor,
                StripForce<float>& product) {
  add_element_forces(slots, search, TurnLaw<float>{factor}, product);
}

double six_volumes_float(const ElementSlots<float>& slots, const State<float>& state, const float* origin,
                         std::size_t begin, std::size_t end) {
  return six_volumes<false>(slots, state, origin, begin, end);
}

double change_of_six_volumes_float(const ElementSlots<float>& slots, const State<float>& search,
                                   const float* origin, std::size_t begin, std::size_t end) {
  return six_volumes<true>(slots, search, origin, begin, end);
}

void push_double(const ElementSlots<double>& slots, const Strip<double>& strip, double factor,
                 StripForce<double>& force) {
  add_element_forces(slots, strip, PushLaw<double>{factor}, force);
}

void turn_double(const ElementSlots<double>& slots, const Strip<double>& search, double factor,
                 StripForce<double>& product) {
  add_element_forces(slots, search, TurnLaw<double>{factor}, product);
}

double six_volumes_double(const ElementSlots<double>& slots, const State<double>& state, const double* origin,
                          std::size_t begin, std::size_t end) {
  return six_volumes<false>(slots, state, origin, begin, end);
}

double change_of_six_volumes_double(const ElementSlots<double>& slots, const State<double>& search,
                                    const double* origin, std::size_t begin, std::size_t end) {
  return six_volumes<true>(slots, search, origin, begin, end);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <cmath>

#include <Eigen/Geometry>

#include "kernels/flush_subnormals.h"
#include "parallel/sum.h"
#include "solve/lane_sums.h"

namespace hooke {
namespace {

HWY_EXPORT(push_float);
HWY_EXPORT(push_double);
HWY_EXPORT(turn_float);
HWY_EXPORT(turn_double);
HWY_EXPORT(six_volumes_float);
HWY_EXPORT(six_volumes_double);
HWY_EXPORT(change_of_six_volumes_float);
HWY_EXPORT(change_of_six_volumes_double);

/// Adds a factor times (b - a) x (c - a) to each corner.
void push(const ElementSlots<float>& slots, const Strip<float>& strip, float factor,
          StripForce<float>& force) {
  HWY_DYNAMIC_DISPATCH(push_float)(slots, strip, factor, force);
}

/// Adds a factor times its change along a direction.
void turn(const ElementSlots<float>& slots, const Strip<float>& search, float factor,
          StripForce<float>& product) {
  HWY_DYNAMIC_DISPATCH(turn_float)(slots, search, factor, product);
}

double six_volumes(const ElementSlots<float>& slots, const State<float>& state, const float* origin,
                   std::size_t begin, std::size_t end) {
  return HWY_DYNAMIC_DISPATCH(six_volumes_float)(slots, state, origin, begin, end);
}

double change_of_six_volumes(const ElementSlots<float>& slots, const State<float>& search,
                             const float* origin, std::size_t begin, std::size_t end) {
  return HWY_DYNAMIC_DISPATCH(change_of_six_volumes_float)(slots, search, origin, begin, end);
}

/// Adds a factor times (b - a) x (c - a) to each corner.
void push(const ElementSlots<double>& slots, const Strip<double>& strip, double factor,
          StripForce<double>& force) {
  HWY_DYNAMIC_DISPATCH(push_double)(slots, strip, factor, force);
}

/// Adds a factor times its change along a direction.
void turn(const ElementSlots<double>& slots, const Strip<double>& search, double factor,
          StripForce<double>& product) {
  HWY_DYNAMIC_DISPATCH(turn_double)(slots, search, factor, product);
}

double six_volumes(const ElementSlots<double>& slots, const State<double>& state, const double* origin,
                   std::size_t begin, std::size_t end) {
  return HWY_DYNAMIC_DISPATCH(six_volumes_double)(slots, state, origin, begin, end);
}

double change_of_six_volumes(const ElementSlots<double>& slots, const State<double>& search,
                             const double* origin, std::size_t begin, std::size_t end) {
  return HWY_DYNAMIC_DISPATCH(change_of_six_volumes_double)(slots, search, origin, begin, end);
}

Elements elements_of(const std::vector<Triangle>& triangles) {
  Elements elements{3, 1};
  for (const auto& [a, b, c] : triangles) elements.add({a, b, c}, {1.0});
  return elements;
}

/// Blocks that one thread takes at a time: some microseconds of work.
constexpr std::size_t measured_blocks = 64;

template <class Real>
class EnclosedGas final : public CompiledEffect<Real> {
 public:
  EnclosedGas(std::string_view name, const std::vector<Triangle>& triangles, PressureOfVolume law,
              const EffectContext<Real>& context)
      : name_(name),
        slots_(make_element_slots<Real>(elements_of(triangles), context.model.order)),
        first_(context.model.order.engine(triangles.front()[0])),
        particles_(double(context.model.particles())),
        law_(std::move(law)) {}

  unsigned parts() const override { return has_force | needs_preparation | is_coupled | has_own_derivative; }

  void prepare(const State<Real>& state, double, Executor& executor) override {
    const Real origin[3] = {state.x()[first_], state.y()[first_], state.z()[first_]};
    const double six = sum(state, executor, [&](std::size_t begin, std::size_t end) {
      return six_volumes(slots_, state, origin, begin, end);
    });
    now_ = law_(six / 6.0);
  }

  void add_force(const Strip<Real>& strip, double, StripForce<Real>& force) const override {
    push(slots_, strip, Real(now_.pressure / 6.0), force);
  }

  /// Of -p' g g^T with g = dV/dx its blocks; what the surface's turning adds is indefinite and left out.
  void add_derivative(const Strip<Real>& strip, double, const DerivativeWeights<Real>& weights,
                      StripBlocks<Real>& blocks) const override {
    StripForce<Real> g{};
    push(slots_, strip, Real(1.0 / 6.0), g);
    const Real weight = weights.stiffness * Real(-now_.slope);
    for (std::size_t i = 0; i < strip.lanes; ++i) {
      blocks.xx[i] += weight * g.x[i] * g.x[i];
      blocks.xy[i] += weight * g.x[i] * g.y[i];
      blocks.xz[i] += weight * g.x[i] * g.z[i];
      blocks.yy[i] += weight * g.y[i] * g.y[i];
      blocks.yz[i] += weight * g.y[i] * g.z[i];
      blocks.zz[i] += weight * g.z[i] * g.z[i];
    }
  }

  /// One element of all particles.
  double coupling() const override { return particles_; }

  void prepare_product(const State<Real>& search, Executor& executor) override {
    const Real origin[3] = {search.x()[first_], search.y()[first_], search.z()[first_]};
    volume_change_ = sum(search, executor, [&](std::size_t begin, std::size_t end) {
      return change_of_six_volumes(slots_, search, origin, begin, end) / 6.0;
    });
  }

  void add_product(const Strip<Real>& search, const DerivativeWeights<Real>& weights, Curvature curvature,
                   StripForce<Real>& product) const override {
    const double weight = double(weights.stiffness);
    push(slots_, search, Real(-weight * now_.slope * volume_change_ / 6.0), product);
    if (curvature == Curvature::exact) turn(slots_, search, Real(-weight * now_.pressure / 6.0), product);
  }

  std::size_t reach() const override { return slots_.reach; }

  /// All of it with the first strip.
  double energy(const Strip<Real>& strip) const override { return strip.first == 0 ? now_.energy : 0.0; }

  Stage stage() const override { return {name_, {}, {"position", "volume"}, {"force"}, slots_.bytes()}; }

  Stage preparation_stage() const override {
    return {name_ + " (volume)", {}, {"position"}, {"volume"}, sums_.capacity() * sizeof(DotSum)};
  }

 private:
  template <class PartOf>
  double sum(const State<Real>& state, Executor& executor, const PartOf& part_of) {
    const auto part = [&](std::size_t begin, std::size_t end) {
      const FlushSubnormals flush;
      return DotSum{part_of(begin, end)};
    };
    return sum_in_order<DotSum>(executor, block_count(state.size()), measured_blocks, part, sums_).value;
  }

  std::string name_;
  ElementSlots<Real> slots_;
  std::size_t first_;  ///< a particle of the surface: volumes are measured from where it is
  double particles_;
  PressureOfVolume law_;
  PressureLaw now_;
  double volume_change_ = 0.0;  ///< along the direction of a product [m^3]
  std::vector<DotSum> sums_;
};

}  // namespace

template <class Real>
EffectPointer<Real> compile_enclosed_gas(std::string_view name, const std::vector<Triangle>& triangles,
                                         PressureOfVolume law, const EffectContext<Real>& context) {
  return std::make_unique<EnclosedGas<Real>>(name, triangles, std::move(law), context);
}

template EffectPointer<float> compile_enclosed_gas(std::string_view, const std::vector<Triangle>&,
                                                   PressureOfVolume, const EffectContext<float>&);
template EffectPointer<double> compile_enclosed_gas(std::string_view, const std::vector<Triangle>&,
                                                    PressureOfVolume, const EffectContext<double>&);

/// Sums of the rows of -p' g g^T, and of the surface's turning: a sixth of each of a triangle's edges times
/// the pressure.
void add_bounds_of_gas(const std::vector<Triangle>& triangles, const PressureLaw& start, const Scene& scene,
                       HeldParticles& held) {
  const auto& x = scene.particles.position;
  std::vector<Vec3> gradient(x.size(), Vec3::Zero());
  for (const auto& [a, b, c] : triangles) {
    const Vec3 sixth = (x[b] - x[a]).cross(x[c] - x[a]) / 6.0;
    const double turning =
        std::abs(start.pressure) / 6.0 * ((x[b] - x[a]).norm() + (x[c] - x[b]).norm() + (x[a] - x[c]).norm());
    for (const Index corner : {a, b, c}) {
      gradient[corner] += sixth;
      held.add(corner, turning, 0.0);
    }
  }
  double sum = 0.0;
  for (const Vec3& g : gradient) sum += g.norm();
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    const double own = gradient[i].norm();
    if (own > 0.0) held.add(Index(i), -start.slope * own * sum, 0.0);
  }
}

}  // namespace hooke
#endif
