#pragma once

#include <limits>
#include <vector>

#include "bench_scenes.h"

namespace hooke::bench {

/// Whether the engine moves a scene as NaiveCloth does, which shares no code with it. At rest springs give no
/// force, so the check starts from positions of its own, where each particle is off its place by up to a
/// tenth of its shortest spring.
class ReferenceCheck {
 public:
  static constexpr int steps = 10;

  /// The largest distance [m] that round-off explains, in a scene of the size of 1 m.
  template <class Real>
  static constexpr double tolerance = steps* double(std::numeric_limits<Real>::epsilon());

  /// Runs the reference, in double. The scene is as it was when this returns.
  explicit ReferenceCheck(BenchScene& bench);

  /// The largest distance [m] of a particle from where the reference has it; infinite where a step went bad.
  /// Leaves the simulation in the state that it was in.
  template <class Real>
  double distance(Simulation<Real>& simulation) const;

  template <class Real>
  bool agrees(Simulation<Real>& simulation) const {
    return distance(simulation) <= tolerance<Real>;
  }

  /// Whether a run stayed good since it had the total energy `energy_before` [J]: all values finite, and, as
  /// no work comes from outside and there is drag, no more energy. Symplectic Euler lets it swing a little,
  /// and round-off of positions stretches springs a little in each step.
  template <class Real>
  bool stayed_good(const Simulation<Real>& simulation, const Report& last_step, double energy_before) const {
    const double rounding = double(std::numeric_limits<Real>::epsilon());  // [m]
    const double heating = 0.5 * stiffness_sum_ * rounding * rounding * double(1 + simulation.steps());
    const Energy energy = simulation.energy();
    const double most = energy_before + 0.01 * (energy.kinetic + energy.elastic) + heating;
    return last_step.ok() && energy.total() <= most;
  }

 private:
  std::vector<Vec3> start_, expected_;  // [m]
  double stiffness_sum_ = 0.0;          // [N/m] of all springs
};

}  // namespace hooke::bench
