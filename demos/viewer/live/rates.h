#pragma once

#include <cstddef>

#include "viewer/live/moment.h"
#include "viewer/live/work.h"

namespace hooke::viewer {

/// Sums up what steps and publishing take, and says every quarter of a second how fast it goes.
class Rates {
 public:
  /// Counts from here on, at this wall time [s] and simulated time [s].
  void start(double now, double simulated);
  /// Forgets what a step took, as another method or other effects take something else.
  void forget() { newest_ = Speeds{}; }

  void add_steps(const Work& work, double seconds);                ///< [s] of wall time that the steps took
  void add_publishing(double seconds) { publishing_ += seconds; }  ///< [s] of the thread's processor time

  /// The newest figures, at this wall time [s] and simulated time [s], for a scene of so many springs.
  const Speeds& speeds(double now, double simulated, std::size_t springs);

 private:
  void clear(double now, double simulated);

  Speeds newest_;
  Work work_;
  double since_ = 0.0, simulated_since_ = 0.0;  // [s]
  double stepping_ = 0.0, publishing_ = 0.0;    // [s] of wall time
};

}  // namespace hooke::viewer
