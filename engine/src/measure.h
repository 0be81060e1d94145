#pragma once

#include <cstdint>
#include <span>

#include <hooke/report.h>
#include <hooke/simulation.h>
#include <hooke/vec3.h>

#include "forces.h"
#include "model/model.h"
#include "state.h"

namespace hooke {

/// Sums over the particles that are not pinned, in double and in a fixed order.
struct ParticleSums {
  double kinetic = 0.0, external = 0.0;  ///< [J]
  Vec3 momentum = Vec3::Zero();          ///< [kg m/s]

  void add(const ParticleSums& other);
};

template <class Real>
ParticleSums sum_particles(const Model<Real>& model, const Forces<Real>& forces, const State<Real>& state,
                           Executor& executor);

/// A hash of the bits of time, positions and velocities in the user's numbering.
template <class Real>
std::uint64_t hash_state(const State<Real>& state, const Order& order);

/// A hash of the bits of some values, going on from another hash.
template <class Real>
std::uint64_t hash_values(std::span<const Real> values, std::uint64_t hash);

/// A hash of the positions and velocities of a snapshot: MethodMemory::state.
template <class Real>
std::uint64_t hash_of_state(const Snapshot<Real>& snapshot) {
  return hash_values<Real>(snapshot.velocities, hash_values<Real>(snapshot.positions, 0));
}

}  // namespace hooke
