#pragma once

#include <cstddef>
#include <cstdint>

#include "collide/local_shape.h"

namespace hooke {

/// Where a collider is: world = rotation local + origin.
template <class Real>
struct Pose {
  Real rotation[3][3];
  Real origin[3];  ///< [m]
};

/// A collider during a step, as particles meet it.
template <class Real>
struct Contact {
  LocalShape<Real> shape;
  Pose<Real> before, after;  ///< at the start and at the end of the step
  Real velocity[3];          ///< of its origin [m/s], in the world
  Real spin[3];              ///< angular velocity [rad/s], in its own frame, which it does not change
  Real thickness;            ///< [m]
  Real friction, restitution;
};

/// A block of particles at the end of a step, whose result may still be changed, and where they were at its
/// start.
template <class Real>
struct ContactBlock {
  Real *x, *y, *z, *vx, *vy, *vz;
  const Real *x0, *y0, *z0;
  std::uint16_t free;  ///< a bit for each lane with a particle that is not pinned
  Real h;              ///< [s] of the step
  std::size_t number;  ///< of the block
};

/// Puts particles of a block that have got into the solid, or through it, back on its surface, with the
/// velocities that the contact leaves them. Returns which, a bit for each lane.
std::uint16_t resolve(const Contact<float>& contact, const ContactBlock<float>& block);
std::uint16_t resolve(const Contact<double>& contact, const ContactBlock<double>& block);

}  // namespace hooke
