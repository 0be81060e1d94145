#pragma once

#include <cstdint>

namespace hooke::viewer {

/// How many steps simulated time needs to keep pace with the wall clock. What a slow scene cannot do in time
/// is given up, so it falls behind and stays responsive.
class Pace {
 public:
  /// Begins at this wall time [s]: nothing is due.
  void start(double now);

  /// Whole steps of `step` [s] that are due at this wall time [s], at `speed` simulated seconds a second [1].
  std::uint64_t steps_due(double now, double speed, double step);

  void took(std::uint64_t steps, double step);

  /// Wall time [s] until the next step is due.
  double wait(double speed, double step) const;

  /// How far the time that is due lies between the last step and the next, in [0, 1].
  double share(double step) const;

 private:
  double last_ = 0.0;  // [s] of wall time
  double due_ = 0.0;   // [s] of simulated time
};

}  // namespace hooke::viewer
