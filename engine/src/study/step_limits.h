#pragma once

#include <cstdint>

#include <hooke/methods.h>
#include <hooke/scene.h>

#include "study/ticks.h"

namespace hooke::study {

/// How long the steps of methods may be on a scene, by the bounds on its frequencies and damping.
class StepLimits {
 public:
  StepLimits(const Scene& scene, double horizon);

  /// The fewest steps to the horizon with which a method is sure to be stable on a scene that is not damped
  /// more than it swings. A method that lets every oscillation grow is taken for one with a limit of 2, where
  /// a study of it may begin. For a method that chooses its steps, about how many it will take at least;
  /// for one that bears any, the fewest that runs take.
  std::uint64_t stable_steps(const Method& method) const;

  /// Steps with which a method of order 4 errs by about `error` radians [1] in the fastest oscillation over
  /// the horizon (of the phase, z^4 / 120 of itself with z = h w, as for the classical Runge-Kutta method).
  std::uint64_t steps_for_phase_error(double error) const;

  /// How often to look at a run of a method that chooses its steps: so that its own steps decide, not the
  /// looks.
  std::uint64_t looks(const Method& method) const;

  double highest_frequency() const { return frequency_; }  ///< [1/s]
  bool is_damped() const { return damping_ > 0.0; }

 private:
  double horizon_;              // [s]
  double frequency_, damping_;  // [1/s]
};

/// The next number of steps that runs may take: a multiple of `unit`, and where that is little more, so many
/// that they meet all ticks.
std::uint64_t rounded_steps(double steps, std::uint64_t unit = fewest_steps);

}  // namespace hooke::study
