#pragma once

#include <chrono>
#include <iosfwd>
#include <string>

namespace hooke::program {

/// A bar, the part done and the time left, estimated from the time `elapsed` [s] that the `fraction` done
/// took.
std::string progress_line(double fraction, double elapsed);

/// One line of a terminal that shows how far a run is, and goes away at the end.
class ProgressBar {
 public:
  /// Shows nothing where `shown` is false.
  ProgressBar(std::ostream& out, bool shown);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// `fraction` of the run is done, in [0, 1].
  void update(double fraction);

  /// Removes the line.
  void clear();

 private:
  using Time = std::chrono::steady_clock;

  std::ostream& out_;
  bool shown_;
  bool drawn_ = false;
  Time::time_point start_ = Time::now(), last_drawn_ = start_;
};

}  // namespace hooke::program
