#include "viewer/live/pace.h"

#include <algorithm>
#include <cmath>

namespace hooke::viewer {

void Pace::start(double now) {
  last_ = now;
  due_ = 0.0;
}

std::uint64_t Pace::steps_due(double now, double speed, double step) {
  constexpr double most_behind = 0.1;  // [s] of wall time
  constexpr double most_steps = 1e9;
  due_ = std::min(due_ + speed * (now - last_), std::max(2.0 * step, speed * most_behind));
  last_ = now;
  return static_cast<std::uint64_t>(std::min(most_steps, std::floor(due_ / step)));
}

void Pace::took(std::uint64_t steps, double step) {
  due_ = std::max(0.0, due_ - static_cast<double>(steps) * step);
}

double Pace::wait(double speed, double step) const {
  return std::max(0.0, (step - due_) / speed);
}

double Pace::share(double step) const {
  return std::clamp(due_ / step, 0.0, 1.0);
}

}  // namespace hooke::viewer
