#include <algorithm>

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "solver.h"

namespace hooke::reference {

std::vector<double> solve_with_fehlberg78(EngineForces& forces, std::vector<double> y, double from, double to,
                                          const Scale& scale, double tolerance) {
  namespace odeint = boost::numeric::odeint;
  using Values = std::vector<double>;
  // It has one absolute tolerance for all values.
  const double absolute = tolerance * std::min(scale.length, scale.speed);
  const auto derivative = [&](const Values& at, Values& result, double time) {
    forces.derivative(time, at, result);
  };
  const auto stepper = odeint::make_controlled(absolute, tolerance, odeint::runge_kutta_fehlberg78<Values>());
  const double first_step = 1e-3 * (to - from);
  odeint::integrate_adaptive(stepper, derivative, y, from, to, first_step);
  return y;
}

}  // namespace hooke::reference
