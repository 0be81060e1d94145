#include "methods/step_controller.h"

#include <algorithm>
#include <cmath>

namespace hooke {
namespace {

constexpr double safety = 0.9, shortest = 0.2, longest = 5.0;

/// Smaller errors say nothing about the length of the next step.
constexpr double least_error = 1e-4;

/// Weights of the error and of the one before it, for order 1 (Gustafsson 1991).
constexpr double proportional = 0.7, integral = 0.4;

}  // namespace

double StepController::after(double error) {
  if (!accepts(error)) {
    rejected_ = true;
    if (!std::isfinite(error)) return shortest;
    return std::clamp(safety * std::pow(error, -1.0 / order_), shortest, safety);
  }
  const double now = std::max(error, least_error);
  const double factor =
      safety * std::pow(now, -proportional / order_) * std::pow(last_error_, integral / order_);
  last_error_ = now;
  // A step that has just been too long is not made longer at once.
  const double limit = rejected_ ? 1.0 : longest;
  rejected_ = false;
  return std::clamp(factor, shortest, limit);
}

}  // namespace hooke
