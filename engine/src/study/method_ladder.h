#pragma once

#include <cstdint>
#include <vector>

#include "study/measured_run.h"
#include "study/step_limits.h"

namespace hooke::study {

/// A run that could be made next.
struct Candidate {
  RunPlan plan;
  double force_evaluations = 0.0;  ///< about so many to the horizon
};

/// The steps, or tolerances, at which one method is run. It begins where the method is surely stable, goes up
/// by factors of two until a run diverges, and down until the errors are far below the tolerance asked for.
/// Tolerances go down by factors of ten.
class MethodLadder {
 public:
  /// All numbers of steps are multiples of `unit`.
  MethodLadder(const Method& method, const StepLimits& limits, const StudySettings& settings,
               std::uint64_t unit);

  const std::vector<Candidate>& candidates() const { return candidates_; }

  /// Takes a candidate out, before its run.
  Candidate take(std::size_t number);

  /// What came of a run decides what can be next. `error` is the largest of its outputs [1], not a number
  /// where there is none; `is_enough` says that a finer run would show nothing more.
  void add_result(const Candidate& candidate, const MeasuredRun& run, double error, bool is_enough);

  /// Wall time for an evaluation of forces [s], of the last run; 0 before the first.
  double seconds_each_evaluation() const { return seconds_each_evaluation_; }

 private:
  bool chooses_steps() const;
  void note_cost(const Candidate& candidate, const MeasuredRun& run);
  void add_steps(std::uint64_t steps);
  void add_tolerance(double tolerance, double force_evaluations);
  void add_coarser(std::uint64_t steps);

  Method method_;
  std::uint64_t looks_;
  double tolerance_, horizon_;
  std::uint64_t unit_;
  std::vector<Candidate> candidates_;
  std::uint64_t coarsest_ = 0, finest_ = 0;  // steps to the horizon of the runs made
  unsigned coarser_runs_ = 0, stable_runs_ = 0;
  double seconds_each_evaluation_ = 0.0;
};

}  // namespace hooke::study
