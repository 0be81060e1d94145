#pragma once

#include <cstdint>
#include <vector>

#include <hooke/simulation.h>

#include "study/study_clock.h"
#include "study/ticks.h"

namespace hooke::study {

/// A method, and in how many steps it is to reach the horizon. A method that chooses its steps is looked at
/// so often.
struct RunPlan {
  Method method;
  std::uint64_t steps = 0;
};

/// What a run has come to at a tick.
struct Sample {
  unsigned tick = 0;
  Energy energy;         ///< [J]
  Vec3 momentum;         ///< [kg m/s]
  double seconds = 0.0;  ///< [s] of wall time in steps, since the start
  std::uint64_t force_evaluations = 0;
};

enum class RunEnd {
  reached,
  diverged,     ///< a step went bad
  out_of_time,  ///< the time given for it was up
  stopped,      ///< by the caller
};

/// A simulation that is run from tick to tick, timed, within a limit of wall time.
class SampledRun {
 public:
  SampledRun(const Scene& scene, const StudySettings& settings, const RunPlan& plan, StudyClock& clock);

  /// Goes on to a tick, which its steps meet. Stops when the study's clock has come to `deadline` [s].
  RunEnd advance_to(unsigned tick, double deadline);

  Sample sample(unsigned tick) const;

  /// Positions in the user's numbering: x, y, z of each particle [m] of the scene, without what has been torn
  /// off these.
  void copy_positions(std::vector<double>& positions) const;

  double time() const { return simulation_.time(); }  ///< [s] simulated
  double seconds() const { return seconds_; }         ///< [s] of wall time in steps
  std::uint64_t force_evaluations() const { return force_evaluations_; }

 private:
  std::uint64_t steps_until_look() const;

  Simulation<double> simulation_;
  std::size_t particles_;
  std::uint64_t steps_to_horizon_;
  StudyClock& clock_;
  double seconds_ = 0.0;
  std::uint64_t force_evaluations_ = 0;
};

}  // namespace hooke::study
