#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>

#include "effects/axial_springs.h"
#include "effects/effect_functions.h"
#include "effects/named_springs.h"
#include "scene/number_text.h"

namespace hooke {
namespace {

/// Springs of two particles with the coefficients k, l0.
Elements elements_of(const Plasticity& plasticity, const Springs& springs) {
  Elements elements{2, 2};
  if (plasticity.rate == 0.0 || plasticity.largest == 0.0) return elements;
  for (const Index s : chosen_springs(plasticity.springs, springs)) {
    if (springs.stiffness[s] > 0.0)
      elements.add({springs.first[s], springs.second[s]}, {springs.stiffness[s], springs.rest_length[s]});
  }
  return elements;
}

/// A spring whose rest length has grown by p pulls with k p less than the scene's law says. State::memory has
/// p of each.
template <class Real>
class PlasticCorrection final : public CompiledEffect<Real> {
 public:
  PlasticCorrection(const Plasticity& plasticity, const EffectContext<Real>& context)
      : plasticity_(plasticity) {
    const Elements elements = elements_of(plasticity, context.scene.springs);
    slots_ = make_element_slots<Real>(elements, context.model.order, true);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const auto end = [&](std::size_t corner) {
        return context.model.order.engine(elements.particles[2 * i + corner]);
      };
      springs_.push_back({end(0), end(1), elements.values[2 * i + 1]});
    }
  }

  unsigned parts() const override {
    return springs_.empty() ? 0 : has_force | is_coupled | has_own_derivative | corrects_everything;
  }

  void add_force(const Strip<Real>& strip, double, StripForce<Real>& force) const override {
    for_each_spring_end(slots_, strip, [&](const ElementCorner<Real>& spring, const Vec3& apart) {
      const double length = apart.norm();
      if (length == 0.0) return;
      const double push = spring.coefficients[0] * creep(strip.state, spring.element);
      add(strip, spring, (spring.role == 0 ? push : -push) / length * apart, force);
    });
  }

  void add_derivative(const Strip<Real>& strip, double, const DerivativeWeights<Real>& weights,
                      StripBlocks<Real>& blocks) const override {
    const auto derivative_of = [&](const ElementCorner<Real>& spring, double length) -> AxialDerivative {
      return {0.0, std::max(double(weights.stiffness) * across(strip.state, spring, length), 0.0)};
    };
    add_axial_blocks(slots_, strip, derivative_of, blocks);
  }

  /// (a - b)^2 <= 2 (a^2 + b^2).
  double coupling() const override { return 2.0; }

  void add_product(const Strip<Real>& search, const DerivativeWeights<Real>& weights, Curvature curvature,
                   StripForce<Real>& product) const override {
    const double least = curvature == Curvature::convex ? 0.0 : std::numeric_limits<double>::lowest();
    for_each_spring_end(slots_, search, [&](const ElementCorner<Real>& spring, const Vec3& apart) {
      const double length = apart.norm();
      if (length == 0.0) return;
      const Vec3 along = apart / length;
      const Vec3 moved = (search.state.velocity(spring.particles[spring.role]) -
                          search.state.velocity(spring.particles[1 - spring.role]))
                             .template cast<double>();
      const double size = double(weights.stiffness) * std::max(across(search.state, spring, length), least);
      add(search, spring, size * (moved - along.dot(moved) * along), product);
    });
  }

  std::size_t reach() const override { return slots_.reach; }

  /// With k (l - l0)^2 / 2, which the simulation counts, k (l - l0 - p)^2 / 2.
  double energy(const Strip<Real>& strip) const override {
    return axial_energy(slots_, strip, [&](const ElementCorner<Real>& spring, double length) {
      const double p = creep(strip.state, spring.element);
      return spring.coefficients[0] * p * (0.5 * p - (length - spring.coefficients[1]));
    });
  }

  std::size_t memory_size() const override { return springs_.size(); }
  void begin_memory(std::size_t first, std::span<Real> own) override {
    first_ = first;
    std::fill(own.begin(), own.end(), Real(0));
  }

  /// At the length that a spring has now, its strain beyond the yield strain decays exponentially.
  void correct(const StepResult<Real>& result, Executor& executor) override {
    constexpr std::size_t springs_at_once = 1024;
    const double share = -std::expm1(-plasticity_.rate * result.h);
    State<Real>& state = result.next;
    executor.parallel_for(springs_.size(), springs_at_once, [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s) {
        const auto& [first, second, rest] = springs_[s];
        Real& p = state.memory[first_ + s];
        const double length = (state.position(first) - state.position(second)).template cast<double>().norm();
        const double strain = (length - rest - double(p)) / rest;
        const double beyond = std::abs(strain) - plasticity_.yield;
        if (!(beyond > 0.0)) continue;
        const double most = plasticity_.largest * rest;
        p = Real(std::clamp(double(p) + std::copysign(share * beyond, strain) * rest, -most, most));
      }
    });
  }

  Stage stage() const override {
    return {std::string(Plasticity::name),
            {},
            {"position", "creep"},
            {"force", "creep"},
            slots_.bytes() + springs_.capacity() * sizeof(PlasticSpring)};
  }

 private:
  struct PlasticSpring {
    Index first, second;  ///< in the engine's order
    double rest;          ///< [m] at the start
  };

  double creep(const State<Real>& state, std::size_t element) const {
    return double(state.memory[first_ + element]);
  }

  /// T / l of the tension -k p.
  double across(const State<Real>& state, const ElementCorner<Real>& spring, double length) const {
    return -spring.coefficients[0] * creep(state, spring.element) / length;
  }

  static void add(const Strip<Real>& strip, const ElementCorner<Real>& spring, const Vec3& value,
                  StripForce<Real>& sum) {
    const std::size_t lane = spring.own - strip.first;
    sum.x[lane] += Real(value.x());
    sum.y[lane] += Real(value.y());
    sum.z[lane] += Real(value.z());
  }

  Plasticity plasticity_;
  ElementSlots<Real> slots_;
  std::vector<PlasticSpring> springs_;
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
