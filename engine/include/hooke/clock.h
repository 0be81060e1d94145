#pragma once

#include <cstdint>

/// A fixed-step clock: frame times of any length go in, whole steps of one length come out.

namespace hooke {

/// What a frame asks for.
struct Tick {
  std::uint64_t steps = 0;  ///< steps to take now
  double interpolation =
      0.0;  ///< how far the frame's time lies between the last two states: 0 the previous, 1 the newest
  double dropped_seconds = 0.0;  ///< [s] given up because the frame asked for more steps than the cap
};

class Clock {
 public:
  /// `step` [s] > 0; at most `max_steps` (>= 1) steps for one frame. Throws SceneError otherwise.
  explicit Clock(double step, std::uint64_t max_steps = 8);

  /// Adds `frame_seconds` [s] (>= 0, finite; throws std::invalid_argument otherwise and changes nothing) and
  /// says how many steps fit. Time beyond the cap is dropped, so a slow machine falls behind instead of
  /// stalling.
  Tick advance(double frame_seconds);

  double step() const { return step_; }
  double remainder() const { return remainder_; }  ///< [s] carried to the next frame, in [0, step)
  void set_remainder(double seconds);              ///< for restoring a snapshot; [0, step)

 private:
  double step_;
  std::uint64_t max_steps_;
  double remainder_ = 0.0;
};

}  // namespace hooke
