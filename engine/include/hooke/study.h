#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <hooke/simulation.h>

/// What accuracy costs in time on a scene: every method at a row of steps or tolerances, each run compared
/// with a reference that is itself checked by a second, independent one. docs/accuracy.md says how to read
/// it.
///
/// Errors are of positions, energy and momentum, never mixed in one number, and never of a state that the two
/// references do not agree upon.

namespace hooke {

inline constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

/// How far a study is.
struct StudyProgress {
  double share = 0.0;         ///< of the budget, in [0, 1]
  double seconds_left = 0.0;  ///< [s] at most
};

/// The question, and what may be spent on it.
struct StudySettings {
  double tolerance = 1e-3;  ///< error that the answer allows, as a share of the scene's size [1], in (0, 1)
  double horizon = 5.0;     ///< [s] of simulated time, > 0
  double budget = 60.0;     ///< [s] of wall time for the study, > 0
  Accumulation accumulation = Accumulation::gather;
  unsigned threads = 0;  ///< at most this many; 0: as many as the machine has
  std::shared_ptr<Executor> executor =
      {};  ///< the host's threads; none: oneTBB's. Then `threads` is not used.
  /// Called about ten times a second from the thread that runs the study; false ends it early.
  std::function<bool(const StudyProgress&)> progress = {};
};

/// A method at one step or tolerance.
struct MethodChoice {
  std::string method;
  double step = 0.0;                ///< [s]; of a method that chooses its steps, their mean
  double tolerance = not_measured;  ///< [1]; not measured for methods of fixed steps
};

/// Such as "verlet, step 0.8 ms" or "dormand_prince, tolerance 1e-06".
std::string to_string(const MethodChoice& choice);

/// What a run did up to one of the study's horizons. Errors that were not measured are not a number.
struct AccuracyRun {
  MethodChoice choice;
  double horizon = 0.0;  ///< [s]

  double rms_error = not_measured;  ///< of positions at the horizon, as a share of the scene's size [1]
  double largest_rms_error = not_measured;  ///< likewise, the largest of all outputs up to the horizon [1]
  double max_error = not_measured;          ///< likewise, of any single particle at any of these outputs [1]
  double energy_error = not_measured;       ///< largest difference from the reference's / energy scale [1]
  double momentum_error = not_measured;     ///< largest difference from the reference's / momentum scale [1]

  std::uint64_t force_evaluations = 0;
  double seconds = 0.0;  ///< [s] of wall time in steps alone, the least of `repeats` equal runs
  unsigned repeats = 0;
  bool diverged = false;
  double diverged_at = not_measured;  ///< [s] of simulated time
  /// The errors of positions are smaller than the reference can tell: less than its smallest_error.
  bool below_reference = false;
};

/// A run that would have been next, and why it was not made.
struct OmittedRun {
  MethodChoice choice;
  std::string reason;
};

struct EnergySample {
  double time = 0.0;  ///< [s]
  Energy energy;      ///< [J]
};

/// How energy went in a run.
struct EnergyHistory {
  MethodChoice choice;
  bool diverged = false;
  std::vector<EnergySample> samples;
};

/// Where positions cannot be compared any more, what can: means over the time from the end of trust to the
/// study's horizon.
struct LongRun {
  MethodChoice choice;
  bool is_reference = false;
  double mean_kinetic_energy = not_measured;  ///< [J]
  double mean_energy = not_measured;          ///< [J] all kinds
  double last_energy = not_measured;          ///< [J] all kinds, at the horizon
  double diverged_at = not_measured;          ///< [s] of simulated time; then there are no means
};

/// Two independent solutions, and how far they agree.
struct Reference {
  std::array<MethodChoice, 2> choices;
  std::array<std::uint64_t, 2> force_evaluations{};
  std::array<double, 2> seconds{};  ///< [s] of wall time
  std::vector<double> times;        ///< [s] of the outputs that both reached
  std::vector<double>
      agreement;               ///< RMS difference of positions at these, as a share of the scene's size [1]
  double reached = 0.0;        ///< [s] both got so far within the budget
  double trusted_until = 0.0;  ///< [s] up to here they agree to 1/100 of the tolerance
  std::vector<EnergySample> energy;  ///< of the one that got further
  std::string verdict;               ///< what of this a reader must know, in words
};

/// The cheapest way to the tolerance, of the runs that were made. Nothing is extrapolated.
struct Answer {
  bool found = false;
  double horizon =
      0.0;  ///< [s] the answer is for: shorter than asked where the reference is not trusted longer
  MethodChoice choice;
  double seconds_per_simulated_second = 0.0;  ///< [1]
  unsigned methods_compared = 0;              ///< that had a run up to the horizon
  std::optional<MethodChoice> next_best;      ///< of the other methods
  double next_best_ratio = 0.0;               ///< its time over that of the best [1]
  std::string text;                           ///< in words
};

struct AccuracyStudy {
  std::string scene;
  std::size_t particles = 0, springs = 0;
  unsigned threads = 0;
  double tolerance = 0.0, horizon = 0.0, budget = 0.0;  ///< as asked: [1], [s], [s]
  double scene_size = 0.0;         ///< [m] diagonal of the box around the particles at the start, or around
                                   ///< their motion where they all start at one place
  double energy_scale = 0.0;       ///< [J] the most energy that moves between its kinds in the reference
  double momentum_scale = 0.0;     ///< [kg m/s] of all mass at the speed of the largest kinetic energy
  double highest_frequency = 0.0;  ///< [1/s] bound

  std::vector<double> horizons;  ///< [s] at which runs are compared, short to long; none without trust
  std::vector<double>
      smallest_errors;  ///< [1] that may be shown at each: 100 times the references' difference
  Reference reference;
  std::vector<AccuracyRun> runs;  ///< by method, from coarse to fine, and by horizon
  std::vector<OmittedRun> omitted;
  std::vector<EnergyHistory> energies;  ///< of each method one run
  std::vector<LongRun> long_runs;       ///< the references' first; none where all of the horizon is trusted
  Answer answer;
  double seconds = 0.0;  ///< [s] of wall time that the study took
  bool stopped = false;  ///< by `progress`
};

/// Studies `scene`. All is computed in double precision. Throws SceneError where the scene or the settings
/// cannot be used, or nothing in the scene can move.
AccuracyStudy study_accuracy(const Scene& scene, const StudySettings& settings = {});

}  // namespace hooke
