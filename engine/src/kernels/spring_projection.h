#pragma once

#include <cstdint>
#include <vector>

#include "aligned.h"
#include "state.h"

namespace hooke {

/// Springs in groups of 16, no two of which share a particle. A place that no spring fills has stiffness and
/// damping zero, and joins a particle to itself that no spring moves.
template <class Real>
struct SpringGroups {
  /// 16 for each group: where the packed vectors of both ends begin, in units of offset_bytes.
  AlignedVector<std::int32_t> first, second;
  AlignedVector<Real> stiffness, rest_length;  ///< [N/m], [m]
  AlignedVector<Real> damping;                 ///< [N s/m]; empty where no spring is damped

  std::size_t bytes() const {
    return (first.capacity() + second.capacity()) * sizeof(std::int32_t) +
           (stiffness.capacity() + rest_length.capacity() + damping.capacity()) * sizeof(Real);
  }
};

/// Packed vectors of each particle. What springs move is kept apart from places, so that it is not rounded
/// off beside them: velocities come from it.
template <class Real>
struct ProjectedParticles {
  const Real* places;  ///< x, y, z [m] without springs, and the inverse mass [1/kg]
  Real* moves;         ///< [m] by springs
  const Real* before;  ///< places at the start of the step; only read where springs are damped
};

/// Puts springs right one after the other, as Macklin, Mueller and Chentanez 2016, with compliance 1 / k.
/// With C = l - l0, n the unit vector along the spring, L the multiplier [N s^2] and w the sum of both
/// inverse masses:
///   dL = -(k h^2 C + L + c h n.(x - x_before)) / ((k h^2 + c h) w + 1),   dx = +-(1 / m) n dL
/// of which neither k = 0 nor infinitely heavy ends divide by zero. Where both ends are at one place there is
/// no direction, and nothing moves.
///
/// The groups [begin, end). `multipliers`: 16 for each group, updated; null stands for zeros that nobody
/// wants to know of later.
template <class Real>
void project_springs(const SpringGroups<Real>& groups, std::size_t begin, std::size_t end, Real h,
                     const ProjectedParticles<Real>& particles, Real* multipliers);

}  // namespace hooke
