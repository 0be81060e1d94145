#pragma once

#include <cstddef>
#include <string_view>

#include <hooke/simulation.h>

#include "scaling/machine_limits.h"

/// What a step needs at least, and how fast a machine can do that: the roofline model (Williams, Waterman and
/// Patterson 2009).

namespace hooke::bench {

/// Useful operations of one spring, each spring counted once, whatever a mode computes twice: difference of
/// the ends 3, square of the length 5, reciprocal root 1, factor k (1 - l0 / l) 3, force 3, added to both
/// ends 6.
constexpr double operations_per_spring = 3 + 5 + 1 + 3 + 3 + 6;

/// And of one particle: gravity 6 (times mass, added), drag 6, and for each coordinate of symplectic Euler 5
/// (force over mass, times step, added to the velocity, that times step, added to the position).
constexpr double operations_per_particle = 6 + 6 + 3 * 5;

/// What one step needs at least.
struct StepCost {
  double operations = 0.0;
  double bytes = 0.0;           ///< [bytes] that must be read or written
  std::size_t working_set = 0;  ///< [bytes] that steps touch again and again, which decides where they lie
};

/// The arithmetic of springs, gravity, drag and symplectic Euler; the traffic of reading and writing each
/// position and velocity once, and of reading all that the plan's stages hold once.
template <class Real>
StepCost step_cost(const Simulation<Real>& simulation) {
  const double particles = double(simulation.particle_count());
  const Plan& plan = simulation.plan();
  std::size_t constants = 0;
  for (const Stage& stage : plan.stages) constants += stage.bytes;
  constexpr double state_values = 12;  // positions and velocities, 3 each, now read and then written
  return {operations_per_spring * double(simulation.spring_count()) + operations_per_particle * particles,
          state_values * sizeof(Real) * particles + double(constants), plan.state_bytes + constants};
}

/// The shortest time that a step can take, and what takes it: L2, L3, memory or arithmetic.
struct StepLimit {
  double seconds = 0.0;  ///< [s]
  std::string_view set_by;
};

/// `operation_rate` [1/s]: of the limits' two, the one for the precision of the step.
StepLimit step_limit(const StepCost& cost, const Caches& caches, unsigned threads, const ThreadLimits& limits,
                     double operation_rate);

}  // namespace hooke::bench
