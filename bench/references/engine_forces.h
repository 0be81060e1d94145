#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <hooke/executor.h>
#include <hooke/scene.h>

#include "forces.h"
#include "model/model.h"
#include "state.h"

namespace hooke::reference {

/// The motion of a scene as y' = f(t, y) in double, for solvers that know nothing of springs: f asks the
/// engine's own force kernel, so what a solver and the engine differ by is the method alone.
///
/// y is x, y, z [m] of each particle that is not pinned, in the user's numbering, and then their velocities
/// [m/s]. Pins are functions of time and not unknowns.
class EngineForces {
 public:
  explicit EngineForces(const Scene& scene);
  EngineForces(const EngineForces&) = delete;
  EngineForces& operator=(const EngineForces&) = delete;

  /// Values in y: six for each free particle. The first half are positions.
  std::size_t unknowns() const { return 6 * free_.size(); }

  /// y of the scene as it stands, at time zero.
  std::vector<double> start() const { return start_; }

  /// f(time [s], y).
  void derivative(double time, std::span<const double> y, std::span<double> result);

  /// How often f was asked for.
  std::uint64_t calls() const { return calls_; }

  /// When a pin's path has a corner, sorted [s]. f or its derivative jumps there: a solver of high order must
  /// end a step there to be of that order.
  const std::vector<double>& corners() const { return corners_; }

  /// The user's number of each free particle, in the order of y.
  const std::vector<Index>& free_particles() const { return free_; }

 private:
  void set_state(double time, std::span<const double> y);

  std::shared_ptr<Executor> executor_;
  Model<double> model_;
  Forces<double> forces_;
  State<double> state_;
  std::vector<Vec3> force_;  ///< [N] in the engine's order
  std::vector<Index> free_;
  std::vector<double> start_, corners_;
  std::uint64_t calls_ = 0;
};

}  // namespace hooke::reference
