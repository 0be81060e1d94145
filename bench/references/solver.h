#pragma once

#include <string_view>
#include <vector>

#include "engine_forces.h"

namespace hooke::reference {

/// What is small in a scene: errors in positions are measured against `length`, those in velocities against
/// `speed`, so that both count alike in a solver's norm.
struct Scale {
  double length = 1.0;  ///< [m]
  double speed = 1.0;   ///< [m/s]
};

/// Solves a scene's motion from y at the time `from` [s] to `to` [s], where no pin's path has a corner in
/// between. The error of a step is held to `tolerance`, relative and of `scale`; what it adds up to is for
/// the caller to find out. Throws std::runtime_error where the solver gives up.
using Solve = std::vector<double> (*)(EngineForces& forces, std::vector<double> y, double from, double to,
                                      const Scale& scale, double tolerance);

/// A solver of another project.
struct Solver {
  std::string_view name;
  Solve solve;
  double tolerance;  ///< the tightest that it was found to hold without being held up by round-off
};

/// CVODE of SUNDIALS: Adams' methods of variable order up to 12, with fixed-point iteration.
std::vector<double> solve_with_cvode(EngineForces& forces, std::vector<double> y, double from, double to,
                                     const Scale& scale, double tolerance);

/// Boost.odeint: Fehlberg's Runge-Kutta pair of orders 7 and 8.
std::vector<double> solve_with_fehlberg78(EngineForces& forces, std::vector<double> y, double from, double to,
                                          const Scale& scale, double tolerance);

/// Those that this build has.
inline std::vector<Solver> solvers() {
  return {
#ifdef HOOKE_ODEINT
      {"odeint Fehlberg 7(8)", solve_with_fehlberg78, 1e-13},
#endif
#ifdef HOOKE_CVODE
      {"CVODE Adams", solve_with_cvode, 1e-13},
#endif
  };
}

/// What y at time zero has become at `end` [s], by a solver with its tightest tolerance, from corner to
/// corner of the pins' paths.
std::vector<double> solution(const Solver& solver, EngineForces& forces, std::vector<double> y, double end,
                             const Scale& scale);

}  // namespace hooke::reference
