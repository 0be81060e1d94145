#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <hooke/report.h>
#include <hooke/scene.h>

#include "viewer/live/setup.h"
#include "viewer/live/step_limit.h"

namespace hooke::viewer {

/// What is measured less often than it is drawn.
struct Measurement {
  std::uint64_t number = 0;  ///< counted up; 0: nothing was measured yet
  double time = 0.0;         ///< [s] simulated
  Energy energy;             ///< [J]
  double max_strain = 0.0;   ///< [1]
};

/// How fast it goes, over the last quarter of a second.
struct Speeds {
  double real_time_ratio = 0.0;     ///< simulated seconds each second of wall time [1]
  double springs_per_second = 0.0;  ///< spring forces [1/s], while steps are taken
  double seconds_per_step = 0.0;    ///< [s]
  std::vector<double> sweeps;       ///< [s] of each sweep of the plan in a step
  double publishing = 0.0;  ///< processor time that showing the state takes of the thread, a second [1]
};

/// What a simulation runs on, until something is changed.
struct InForce {
  std::uint64_t number = 0;  ///< counted up with each change
  Setup setup;
  Plan plan;
  std::vector<std::string> sweeps;     ///< of the plan, in their order
  std::optional<StepLimit> stability;  ///< of setup's method on setup's effects
  std::size_t particles = 0, springs = 0;
  std::shared_ptr<const Scene> torn;  ///< the scene as it has torn; null where it has not
  unsigned threads = 1;
};

/// What a viewer sees of a simulation at one moment.
struct Moment {
  std::vector<float> positions;  ///< x, y, z of each particle in the user's numbering [m]
  double time = 0.0;             ///< [s] simulated
  std::uint64_t steps = 0;
  bool running = false;
  double speed = 1.0;  ///< that is asked for [1]
  Speeds speeds;
  std::vector<Measurement> measurements;  ///< the newest last, and so many before it that none is missed
  std::shared_ptr<const InForce> in_force;
  std::string problem;  ///< why the run stopped, and what to do; empty: it did not
  std::string refusal;  ///< why the last change was not made; empty: it was
};

}  // namespace hooke::viewer
