#pragma once

#include <limits>

#include <hooke/stability.h>

namespace hooke {

/// All that is found from a scene's springs and effects to know how long steps may be. Found once: a scene
/// may be large.
struct SceneBounds {
  double frequency = 0.0;     ///< highest_frequency() [1/s]
  double damping_rate = 0.0;  ///< highest_damping_rate() [1/s]
  /// The longest step [s] at which stability_number() is at most 4: what a method of one kick and one drift
  /// surely bears.
  double kick_and_drift = std::numeric_limits<double>::infinity();
  double damping_ratio = 0.0;            ///< see Stability
  Index worst_damper = Stability::none;  ///< likewise
};

SceneBounds bounds_of(const Scene& scene);

/// largest_stable_step() of a scene with these bounds [s].
double largest_stable_step(const SceneBounds& bounds, const Method& method);

}  // namespace hooke
