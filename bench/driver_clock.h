#pragma once

namespace hooke::bench {

/// CPU time of this thread [s].
double thread_seconds();

/// Counts the CPU time that this thread spends within calls of OpenGL: puts itself between the renderer and
/// the driver, so that nothing needs to be timed by hand. A function that it does not know counts as the
/// renderer's.
class DriverClock {
 public:
  /// Begins to count. All functions that are drawn with must have been called once, as libepoxy looks each up
  /// by its first call.
  DriverClock();
  ~DriverClock();
  DriverClock(const DriverClock&) = delete;
  DriverClock& operator=(const DriverClock&) = delete;

  double seconds() const;
  unsigned long calls() const;
};

}  // namespace hooke::bench
