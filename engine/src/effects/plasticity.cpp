#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>

#include "effects/axial_springs.h"
#include "effects/effect_functions.h"
#include "effects/named_springs.h"
#include "kernels/flush_subnormals.h"
#include "scene/number_text.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/plasticity.cpp"
#include <hwy/foreach_target.h>

#include "kernels/axial-inl.h"

#ifndef HOOKE_PLASTICITY
#define HOOKE_PLASTICITY
namespace hooke {

/// How springs creep within a step, in the precision of the run.
template <class Real>
struct Creep {
  Real share;    ///< of the strain beyond the yield strain, that becomes creep
  Real yield;    ///< strain
  Real largest;  ///< over the rest length
};

}  // namespace hooke
#endif

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

/// A spring with the coefficients k, l0 whose rest length has grown by p, which is remembered, pulls with k p
/// less than the scene's law says.
template <class Real>
struct Law {
  static constexpr std::size_t corners = 2, coefficients = 2;
  static constexpr bool velocities = false;
  const Real* memory;

  template <std::size_t role, class D, class Element, class V>
  HWY_INLINE auto force(D d, const Element& e, V creep) const {
    return pull<role>(d, hn::Neg(hn::Mul(e.c[0], creep)), axis_of(d, e));
  }
};

/// The tension is the same at every length, so there is a derivative only across.
template <class Real>
struct ProductLaw {
  static constexpr std::size_t corners = 2, coefficients = 2;
  static constexpr bool velocities = true;
  const Real* memory;
  Real weight, least_across;  ///< 0 where what is pressed must not buckle, else the lowest number

  template <std::size_t role, class D, class Element, class V>
  HWY_INLINE auto force(D d, const Element& e, V creep) const {
    const auto axis = axis_of(d, e);
    const auto tension = hn::Neg(hn::Mul(e.c[0], creep));
    const auto across = hn::Mul(hn::Set(d, weight), hn::Mul(tension, axis.inverse_length));
    return axial_product<role>(d, hn::Zero(d), hn::Max(across, hn::Set(d, least_across)), axis, e);
  }
};

/// The creep after a step, at the length that springs have at its end.
template <class D, class V, class Real, class Element>
HWY_INLINE V crept(D d, const Element& e, V creep, const Creep<Real>& of) {
  const V rest = e.c[1], length = axis_of(d, e).length;
  const V strain = hn::Div(hn::Sub(hn::Sub(length, rest), creep), rest);
  const V beyond = hn::Sub(hn::Abs(strain), hn::Set(d, of.yield));
  const V more = hn::Mul(hn::CopySign(hn::Mul(hn::Set(d, of.share), beyond), strain), rest);
  const V most = hn::Mul(hn::Set(d, of.largest), rest);
  const V next = hn::Max(hn::Neg(most), hn::Min(hn::Add(creep, more), most));
  return hn::IfThenElse(hn::Gt(beyond, hn::Zero(d)), next, creep);
}

/// Each spring is looked at once: where its first end lies in a lane. Those of sleepers stay as they are.
template <class Real>
HWY_INLINE void creep_blocks(const ElementSlots<Real>& slots, const Model<Real>& model,
                             const State<Real>& state, const Creep<Real>& of, std::size_t begin,
                             std::size_t end, Real* memory) {
  for (std::size_t block = begin; block < end; ++block) {
    const auto& list = slots.list(block);
    for (std::uint32_t s = list.begin; s < list.end; ++s) {
      const auto& slot = slots.slots[s];
      if (slot.role != 0) continue;
      alignas(cache_line) Real next[block_size];
      for_each_lane_element<2, 2, false>(
          slots, slot, state, block, [&](auto d, const auto& e, std::size_t lane) HWY_ATTR {
            const auto creep = hn::GatherIndex(d, memory, element_numbers(d, slots, slot, lane));
            hn::Store(crept(d, e, creep, of), d, next + lane);
          });
      for (std::size_t lane = 0; lane < block_size; ++lane) {
        if (slots.has_element(slot, lane) && !model.sleeps(block * block_size + lane))
          memory[slots.element_row(slot)[lane]] = next[lane];
      }
    }
  }
}

}  // namespace

#define HOOKE_PLASTICITY_IN(Real)                                                                            \
  void yield_##Real(const ElementSlots<Real>& slots, const Strip<Real>& strip, const Real* memory,           \
                    StripForce<Real>& force) {                                                               \
    add_element_forces(slots, strip, Law<Real>{memory}, force);                                              \
  }                                                                                                          \
  void multiply_yield_##Real(const ElementSlots<Real>& slots, const Strip<Real>& search, const Real* memory, \
                             Real weight, Real least_across, StripForce<Real>& product) {                    \
    add_element_forces(slots, search, ProductLaw<Real>{memory, weight, least_across}, product);              \
  }                                                                                                          \
  void creep_##Real(const ElementSlots<Real>& slots, const Model<Real>& model, const State<Real>& state,     \
                    const Creep<Real>& of, std::size_t begin, std::size_t end, Real* memory) {               \
    creep_blocks(slots, model, state, of, begin, end, memory);                                               \
  }
HOOKE_PLASTICITY_IN(float)
HOOKE_PLASTICITY_IN(double)
#undef HOOKE_PLASTICITY_IN

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {
namespace {

#define HOOKE_PLASTICITY_IN(Real)                                                                      \
  HWY_EXPORT(yield_##Real);                                                                            \
  HWY_EXPORT(multiply_yield_##Real);                                                                   \
  HWY_EXPORT(creep_##Real);                                                                            \
  void add_yield(const ElementSlots<Real>& slots, const Strip<Real>& strip, const Real* memory,        \
                 StripForce<Real>& force) {                                                            \
    HWY_DYNAMIC_DISPATCH(yield_##Real)(slots, strip, memory, force);                                   \
  }                                                                                                    \
  void multiply_yield(const ElementSlots<Real>& slots, const Strip<Real>& search, const Real* memory,  \
                      Real weight, Real least_across, StripForce<Real>& product) {                     \
    HWY_DYNAMIC_DISPATCH(multiply_yield_##Real)(slots, search, memory, weight, least_across, product); \
  }                                                                                                    \
  void creep(const ElementSlots<Real>& slots, const Model<Real>& model, const State<Real>& state,      \
             const Creep<Real>& of, std::size_t begin, std::size_t end, Real* memory) {                \
    HWY_DYNAMIC_DISPATCH(creep_##Real)(slots, model, state, of, begin, end, memory);                   \
  }
HOOKE_PLASTICITY_IN(float)
HOOKE_PLASTICITY_IN(double)
#undef HOOKE_PLASTICITY_IN

/// Springs of two particles with the coefficients k, l0.
Elements elements_of(const Plasticity& plasticity, const Springs& springs) {
  Elements elements{2, 2};
  for (const Index s : creeping_springs(plasticity, springs))
    elements.add({springs.first[s], springs.second[s]}, {springs.stiffness[s], springs.rest_length[s]});
  return elements;
}

/// Blocks that one thread takes at a time: some microseconds of work.
constexpr std::size_t blocks_at_once = 64;

/// State::memory has the creep p of each spring.
template <class Real>
class PlasticCorrection final : public CompiledEffect<Real> {
 public:
  PlasticCorrection(const Plasticity& plasticity, const EffectContext<Real>& context)
      : plasticity_(plasticity), model_(context.model) {
    const Elements elements = elements_of(plasticity, context.scene.springs);
    slots_ = make_element_slots<Real>(elements, context.model.order, true);
    springs_ = elements.size();
  }

  unsigned parts() const override {
    return springs_ == 0 ? 0 : has_force | is_coupled | has_own_derivative | corrects_everything;
  }

  void add_force(const Strip<Real>& strip, double, StripForce<Real>& force) const override {
    add_yield(slots_, strip, strip.state.memory.data() + first_, force);
  }

  void add_derivative(const Strip<Real>& strip, double, const DerivativeWeights<Real>& weights,
                      StripBlocks<Real>& blocks) const override {
    const auto derivative_of = [&](const ElementCorner<Real>& spring, double length) -> AxialDerivative {
      const double across = -spring.coefficients[0] * creep_of(strip.state, spring.element) / length;
      return {0.0, std::max(double(weights.stiffness) * across, 0.0)};
    };
    add_axial_blocks(slots_, strip, derivative_of, blocks);
  }

  /// (a - b)^2 <= 2 (a^2 + b^2).
  double coupling() const override { return 2.0; }

  void add_product(const Strip<Real>& search, const DerivativeWeights<Real>& weights, Curvature curvature,
                   StripForce<Real>& product) const override {
    const Real least = curvature == Curvature::convex ? Real(0) : std::numeric_limits<Real>::lowest();
    multiply_yield(slots_, search, search.state.memory.data() + first_, weights.stiffness, least, product);
  }

  std::size_t reach() const override { return slots_.reach; }

  /// With k (l - l0)^2 / 2, which the simulation counts, k (l - l0 - p)^2 / 2.
  double energy(const Strip<Real>& strip) const override {
    return axial_energy(slots_, strip, [&](const ElementCorner<Real>& spring, double length) {
      const double p = creep_of(strip.state, spring.element);
      return spring.coefficients[0] * p * (0.5 * p - (length - spring.coefficients[1]));
    });
  }

  std::size_t memory_size() const override { return springs_; }
  void begin_memory(std::size_t first, std::span<Real> own) override {
    first_ = first;
    std::fill(own.begin(), own.end(), Real(0));
  }

  /// At the length that a spring has now, its strain beyond the yield strain decays exponentially.
  void correct(const StepResult<Real>& result, Executor& executor) override {
    const Creep<Real> of{Real(-std::expm1(-plasticity_.rate * result.h)), Real(plasticity_.yield),
                         Real(plasticity_.largest)};
    State<Real>& state = result.next;
    executor.parallel_for(block_count(state.size()), blocks_at_once, [&](std::size_t begin, std::size_t end) {
      const FlushSubnormals flush;
      model_.for_each_awake_run(begin, end, [&](std::size_t first, std::size_t last) {
        creep(slots_, model_, state, of, first, last, state.memory.data() + first_);
      });
    });
  }

  Stage stage() const override {
    return {std::string(Plasticity::name), {}, {"position", "creep"}, {"force", "creep"}, slots_.bytes()};
  }

 private:
  double creep_of(const State<Real>& state, std::size_t spring) const {
    return double(state.memory[first_ + spring]);
  }

  Plasticity plasticity_;
  const Model<Real>& model_;
  ElementSlots<Real> slots_;
  std::size_t springs_;
  std::size_t first_ = 0;  ///< of its values in State::memory
};

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const Plasticity& plasticity, const EffectContext<Real>& context) {
  return std::make_unique<PlasticCorrection<Real>>(plasticity, context);
}

template EffectPointer<float> compile_effect(const Plasticity&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const Plasticity&, const EffectContext<double>&);

void check_effect(const Plasticity& plasticity, const Scene& scene, const ElementChecks& checks) {
  checks.not_negative("yield", plasticity.yield, "");
  checks.not_negative("rate", plasticity.rate, "1/s");
  checks.not_negative("largest", plasticity.largest, "");
  if (plasticity.largest >= 1.0) {
    checks.add("largest is " + to_text(plasticity.largest) + ": a spring could creep to no length",
               "give a value in [0, 1)");
  }
  check_strained_springs(plasticity.springs, scene, checks);
  check_only_law(plasticity, scene, checks);
}

/// A spring is never stiffer than it was, as its rest length stays above zero.
void add_bounds(const Plasticity&, const Scene&, HeldParticles&) {}

}  // namespace hooke
#endif
