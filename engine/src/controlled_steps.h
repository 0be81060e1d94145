#pragma once

#include <limits>

#include "methods/error_norm.h"
#include "methods/step_controller.h"
#include "step.h"

namespace hooke {

/// Goes one step of the simulation in as many steps of an error-controlled method as its tolerance needs.
template <class Real>
class ControlledSteps {
 public:
  /// What a step is allowed comes from the size of the scene [m] and `start`, the state in which it begins.
  ControlledSteps(const DormandPrince& method, double scene_size, RungeKutta<Real>& runge_kutta,
                  const Model<Real>& model, Forces<Real>& forces, Executor& executor,
                  const State<Real>& start);

  enum class Outcome { reached, not_finite, step_too_small };

  /// What happened on the way.
  struct Result {
    Outcome outcome = Outcome::reached;
    Index bad = Report::none;  ///< a particle that stayed not finite however short the step
    std::uint64_t evaluations = 0, rejected = 0;
  };

  /// Goes from the newest state of the ring, which is advanced, to the time `end` [s]; it stays as it is
  /// where the end is not reached.
  Result go(const PlanRun<Real>& run, double end, StateRing<Real>& states);

  /// The length [s] that the next step will be tried with; 0 before the first.
  double next_step() const { return next_step_; }
  double last_error() const { return controller_.last_error(); }

  /// The newest state has been changed from outside. Goes on with a length and an error as above.
  void restart(double next_step, double last_error);

 private:
  /// A step of the embedded result, of order 4, has an error of order 5.
  static constexpr double order_of_error = 5.0;

  void evaluate_at(const State<Real>& state, std::size_t stage);

  /// The length [s] of the step to try where `left` [s] are left: the last one ends at the end, and the one
  /// before it is cut so that the last is not a tiny one.
  double length_of_step(double left) const;

  /// Takes the step after the first `taken` of the ring, and finds its error.
  struct Attempt {
    Index bad = Report::none;
    double error = std::numeric_limits<double>::infinity();
  };
  Attempt attempt(const PlanRun<Real>& run, const StepTimes& times, std::size_t taken,
                  StateRing<Real>& states);

  double smallest_step_;
  RungeKutta<Real>& runge_kutta_;
  const Model<Real>& model_;
  Forces<Real>& forces_;
  Executor& executor_;
  StepController controller_;
  AllowedError allowed_;
  bool first_known_ = true;  ///< the accelerations of stage 0 are those of the newest state
  double next_step_ = 0.0;
  std::vector<SquareSums> sums_;  ///< room for the error's
};

}  // namespace hooke
