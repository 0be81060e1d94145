#include "program/frame_schedule.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace hooke::program {
namespace {

constexpr double most_steps = 9007199254740992.0;  // 2^53: up to here a double counts every step

}  // namespace

FrameSchedule::FrameSchedule(double seconds, double step, double fps)
    : steps_(0),
      steps_per_frame_(std::clamp(1.0 / (fps * step), 1.0, most_steps)),
      fps_(1.0 / (steps_per_frame_ * step)) {
  const double steps = std::round(seconds / step);
  if (!(steps <= most_steps)) {
    std::ostringstream message;
    message << seconds << " s in steps of " << step
            << " s are too many steps; give a longer --step or fewer --seconds";
    throw std::invalid_argument(message.str());
  }
  steps_ = static_cast<std::uint64_t>(steps);
}

std::uint64_t FrameSchedule::step_of(std::uint64_t frame) const {
  // A frame beyond the last step is never reached, and must not overflow on its way there.
  const double step = std::round(static_cast<double>(frame) * steps_per_frame_);
  return step <= static_cast<double>(steps_) ? static_cast<std::uint64_t>(step) : steps_ + 1;
}

}  // namespace hooke::program
