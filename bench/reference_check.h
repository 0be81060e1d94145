#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "bench_scenes.h"

namespace hooke::bench {

/// Whether a program moves a scene as NaiveCloth does, which shares no code with the engine. At rest springs
/// give no force, so the check starts from positions of its own, where each particle is off its place by up
/// to a tenth of its shortest spring.
class ReferenceCheck {
 public:
  static constexpr int steps = 10;  ///< of the check

  /// The largest distance [m] that round-off explains, in a scene of the size of 1 m.
  template <class Real>
  static constexpr double tolerance = steps* double(std::numeric_limits<Real>::epsilon());

  /// Runs the reference, in double. The scene is as it was when this returns.
  explicit ReferenceCheck(BenchScene& bench);

  /// The positions [m] that the check starts from, at rest.
  const std::vector<Vec3>& start() const { return start_; }

  /// The largest distance [m] of a particle from where the reference has it after the steps of the check;
  /// infinite where a position is not finite.
  double distance(const std::vector<Vec3>& positions) const;

  /// The same for a simulation; infinite where a step goes bad. Leaves it in the state that it was in.
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

/// A scene and how runs of it are checked.
struct CheckedScene {
  BenchScene bench;
  ReferenceCheck check;

  explicit CheckedScene(BenchScene given) : bench(std::move(given)), check(bench) {}

  /// The scene as it is when its check starts.
  Scene start_of_check() const;
};

/// The largest distance [m] between particles of the same number; infinite if one is not finite.
double largest_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

/// All positions [m] in the user's numbering.
template <class Real>
std::vector<Vec3> positions_of(const Simulation<Real>& simulation) {
  std::vector<Vec3> positions(simulation.particle_count());
  simulation.copy_positions(positions[0].data(), sizeof(Vec3));
  return positions;
}

}  // namespace hooke::bench
