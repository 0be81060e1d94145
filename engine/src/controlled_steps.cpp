#include "controlled_steps.h"

#include <algorithm>

#include "methods/evaluate.h"

namespace hooke {

template <class Real>
ControlledSteps<Real>::ControlledSteps(const DormandPrince& method, double scene_size,
                                       RungeKutta<Real>& runge_kutta, const Model<Real>& model,
                                       Forces<Real>& forces, Executor& executor, const State<Real>& start)
    : smallest_step_(method.smallest_step),
      runge_kutta_(runge_kutta),
      model_(model),
      forces_(forces),
      executor_(executor),
      controller_(order_of_error) {
  evaluate_at(start, 0);
  allowed_ = allowed_error(method, scene_size, model, start, runge_kutta.accelerations());
}

template <class Real>
void ControlledSteps<Real>::evaluate_at(const State<Real>& state, std::size_t stage) {
  evaluate(state, model_, forces_, executor_, runge_kutta_.accelerations(), stage);
}

template <class Real>
double ControlledSteps<Real>::length_of_step(double left) const {
  if (next_step_ >= left) return left;
  return std::min(next_step_, left / 2.0);
}

template <class Real>
auto ControlledSteps<Real>::attempt(const PlanRun<Real>& run, const StepTimes& times, std::size_t taken,
                                    StateRing<Real>& states) -> Attempt {
  Attempt attempt;
  attempt.bad = take_steps(run, times, taken, 1, states);
  if (attempt.bad != Report::none) return attempt;
  evaluate_at(states.after(taken + 1), runge_kutta_.stages());
  attempt.error = error_norm(allowed_, times.h(), model_, runge_kutta_.accelerations(), executor_, sums_);
  return attempt;
}

template <class Real>
auto ControlledSteps<Real>::go(const PlanRun<Real>& run, double end, StateRing<Real>& states) -> Result {
  Result result;
  double time = states.now().time;
  if (!first_known_) {
    evaluate_at(states.now(), 0);
    ++result.evaluations;
  }
  first_known_ = false;  // until the end is reached
  if (next_step_ == 0.0) next_step_ = end - time;

  std::size_t taken = 0;
  while (time < end) {
    const double h = length_of_step(end - time);
    const Attempt tried = attempt(run, {time, 0, h}, taken, states);
    result.evaluations += runge_kutta_.stages();
    const double proposed = h * controller_.after(tried.error);
    if (!StepController::accepts(tried.error)) {
      ++result.rejected;
      next_step_ = proposed;
      if (next_step_ >= smallest_step_) continue;
      result.outcome = tried.bad == Report::none ? Outcome::step_too_small : Outcome::not_finite;
      result.bad = tried.bad;
      restart(0.0, 1.0);
      return result;
    }
    const bool last = h == end - time;
    // A last step may be shorter than it could be.
    next_step_ = last ? std::max(next_step_, proposed) : proposed;
    if (last) states.after(taken + 1).time = end;
    ++taken;
    time = states.after(taken).time;
    runge_kutta_.accelerations().copy(runge_kutta_.stages(), 0);
  }
  if (taken > 0) states.advance_as_one(taken);
  first_known_ = true;
  return result;
}

template <class Real>
void ControlledSteps<Real>::restart(double next_step, double last_error) {
  first_known_ = false;
  next_step_ = next_step;
  controller_ = StepController(order_of_error);
  controller_.set_last_error(last_error);
}

template class ControlledSteps<float>;
template class ControlledSteps<double>;

}  // namespace hooke
