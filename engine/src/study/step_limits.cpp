#include "study/step_limits.h"

#include <algorithm>
#include <cmath>

#include <hooke/stability.h>

#include "study/method_traits.h"
#include "study/ticks.h"

namespace hooke::study {
namespace {

constexpr double most_steps = 1e15;  // of what double tells apart, and beyond any budget

}  // namespace

std::uint64_t rounded_steps(double steps, std::uint64_t unit) {
  const double fine = 5.0 * last_tick;  // rounding up to whole ticks costs at most a fifth from here on
  const double multiple = steps >= fine ? last_tick : double(unit);
  return std::uint64_t(multiple * std::max(1.0, std::ceil(std::min(steps, most_steps) / multiple)));
}

StepLimits::StepLimits(const Scene& scene, double horizon)
    : horizon_(horizon),
      frequency_(hooke::highest_frequency(scene)),
      damping_(hooke::highest_damping_rate(scene)) {}

std::uint64_t StepLimits::stable_steps(const Method& method) const {
  if (solves_equations(method)) return fewest_steps;
  const double given = traits_of(method).oscillation_limit;
  const double limit = given > 0.0 ? given : 2.0;
  // h^2 w^2 + 2 h c = limit^2, as in stability_number(), solved for 1 / h: no case is apart where w is 0.
  const double inverse = (damping_ + std::hypot(damping_, frequency_ * limit)) / (limit * limit);
  return rounded_steps(horizon_ * inverse);
}

std::uint64_t StepLimits::steps_for_phase_error(double error) const {
  const double phase = frequency_ * horizon_;  // [1] radians
  if (phase == 0.0) return 10 * last_tick;
  return rounded_steps(phase * std::pow(phase / (120.0 * error), 0.25));
}

std::uint64_t StepLimits::looks(const Method& method) const {
  constexpr std::uint64_t steps_between_looks = 32;
  const std::uint64_t steps = stable_steps(method);
  if (steps < last_tick) return fewest_steps;
  return last_tick * ((steps / last_tick + steps_between_looks - 1) / steps_between_looks);
}

}  // namespace hooke::study
