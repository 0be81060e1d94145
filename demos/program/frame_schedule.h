#pragma once

#include <cstdint>

namespace hooke::program {

/// Which steps a run takes and after which of them it has a frame.
class FrameSchedule {
 public:
  /// A run of `seconds` [s] >= 0 in steps of `step` [s] > 0, with `fps` [1/s] > 0 frames for each simulated
  /// second. Where frames would come faster than steps, each step has one. Throws std::invalid_argument where
  /// the steps are too many to count.
  FrameSchedule(double seconds, double step, double fps);

  std::uint64_t steps() const { return steps_; }
  double fps() const { return fps_; }  ///< [1/s] frames that come for each simulated second

  /// The number of steps after which frame `frame` shows the state: 0 for frame 0, and later for each one.
  std::uint64_t step_of(std::uint64_t frame) const;

 private:
  std::uint64_t steps_;
  double steps_per_frame_;
  double fps_;
};

}  // namespace hooke::program
