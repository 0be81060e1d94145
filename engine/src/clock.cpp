#include <hooke/clock.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <hooke/scene.h>

namespace hooke {

Clock::Clock(double step, std::uint64_t max_steps) : step_(step), max_steps_(max_steps) {
  std::vector<Fault> faults;
  if (!std::isfinite(step) || step <= 0.0) {
    faults.push_back({"clock", "step is " + std::to_string(step) + " s", "give a finite value > 0"});
  }
  if (max_steps < 1) faults.push_back({"clock", "max_steps is 0", "give a value >= 1"});
  if (!faults.empty()) throw SceneError(std::move(faults));
}

Tick Clock::advance(double frame_seconds) {
  if (!std::isfinite(frame_seconds) || frame_seconds < 0.0) {
    throw std::invalid_argument("clock: frame time is " + std::to_string(frame_seconds) +
                                " s; give a finite value >= 0");
  }
  Tick tick;
  const double available = remainder_ + frame_seconds;
  // Frame times that are meant to be whole steps come out a rounding error short: without this they would
  // give n - 1 steps in one frame and n + 1 in another.
  constexpr double rounding = 1e-9;
  const double whole = std::floor(available / step_ + rounding);
  tick.steps = std::uint64_t(std::min(whole, double(max_steps_)));
  const double kept = available - double(tick.steps) * step_;
  // What the cap cuts off is dropped in whole steps, so that the fraction keeps its phase.
  const double dropped_steps = std::max(whole - double(tick.steps), 0.0);
  tick.dropped_seconds = dropped_steps * step_;
  remainder_ = std::clamp(kept - tick.dropped_seconds, 0.0, std::nextafter(step_, 0.0));
  tick.interpolation = remainder_ / step_;
  return tick;
}

void Clock::set_remainder(double seconds) {
  if (!(seconds >= 0.0 && seconds < step_)) {
    throw std::invalid_argument("clock: remainder is " + std::to_string(seconds) +
                                " s; give a value in [0, step)");
  }
  remainder_ = seconds;
}

}  // namespace hooke
