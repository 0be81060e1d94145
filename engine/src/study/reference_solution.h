#pragma once

#include <array>
#include <vector>

#include <hooke/study.h>

#include "study/sampled_run.h"
#include "study/step_limits.h"

namespace hooke::study {

/// An error that is shown is at least so many times the difference of the references.
inline constexpr double trust_factor = 100.0;

/// What runs are compared with.
struct ReferenceSolution {
  Reference report;
  std::array<std::vector<Sample>, 2> samples;  ///< of both, at each tick from 0 to the last that it reached
  std::vector<std::vector<double>>
      positions;                     ///< of the first [m], at each tick; empty where that is no output
  std::vector<double> disagreement;  ///< [1] RMS, at each tick the largest up to it
  unsigned reached = 0;              ///< last output that both reached
  unsigned trusted = 0;         ///< last output up to which they agree to 1/100 of the tolerance; 0: none
  double scene_size = 0.0;      ///< [m]
  double energy_scale = 0.0;    ///< [J]
  double momentum_scale = 0.0;  ///< [kg m/s]
  double seconds_each_evaluation = 0.0;  ///< [s] of wall time
  std::size_t free_particles = 0;
  bool broke_down = false;  ///< a step of one of them went bad
  bool stopped = false;

  /// Whether one of them got to the end of the study's horizon, so that there is something to be said of it.
  bool reaches_horizon() const;

  /// What energy and momentum should be at a tick, by the reference that got so far; else by the last sample.
  const Sample& expected(unsigned tick) const;

  /// The smallest error of positions that may be shown up to a tick that both reached [1].
  double smallest_error(unsigned tick) const { return trust_factor * disagreement[tick]; }
};

/// Solves the scene twice, with methods of two families: steps chosen by a tolerance, and fixed ones. Takes
/// what its share of the budget allows, and no more than the tolerance asks for.
ReferenceSolution make_reference(const Scene& scene, const StudySettings& settings, const StepLimits& limits,
                                 StudyClock& clock);

/// What a reader must know of a reference, in words.
std::string verdict(const ReferenceSolution& solution, const StudySettings& settings);

}  // namespace hooke::study
