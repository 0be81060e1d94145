#pragma once

#include <vector>

#include <hooke/methods.h>

#include "methods/accelerations.h"
#include "model/model.h"

namespace hooke {

/// What error control allows in each of its steps, as root of the mean square over particles.
struct AllowedError {
  double position;             ///< [m], > 0
  double velocity;             ///< [m/s], > 0
  std::size_t free_particles;  ///< that are not pinned
};

/// From the size of the scene [m], the state at its start and the accelerations there, of stage 0; see
/// DormandPrince.
template <class Real>
AllowedError allowed_error(const DormandPrince& method, double size, const Model<Real>& model,
                           const State<Real>& start, const Accelerations<Real>& accelerations);

/// Sums over particles, for means.
struct SquareSums {
  double position = 0.0, velocity = 0.0;

  void add(const SquareSums& other) {
    position += other.position;
    velocity += other.velocity;
  }
};

/// The error of a step of length h [s], divided by what is allowed in it [1]: the root of the mean square
/// over the positions and velocities of the particles that are not pinned. Not finite where accelerations are
/// not. Summed in a fixed order, with `results` for room.
template <class Real>
double error_norm(const AllowedError& allowed, double h, const Model<Real>& model,
                  const Accelerations<Real>& accelerations, Executor& executor,
                  std::vector<SquareSums>& results);

}  // namespace hooke
