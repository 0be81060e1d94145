#pragma once

#include <cmath>

namespace hooke {

/// The force of one spring on the particle that sees the other end at d = (dx, dy, dz), moving at (vx, vy,
/// vz) relative to it, is `factor` times d:
///   F = (k (l - l0) + c (v.n)) n,  n = d / l   =>   factor = k (1 - l0 / l) + c (v.d) / l^2.
/// Where l is zero, or so short that its square is, there is no direction: the factor stays finite and d is
/// zero.
///
/// Both ends compute the same bits with opposite sign, whatever the instruction set: every product of d and v
/// keeps its value when both change sign, and sums run in the same order.
template <class Real, bool damped>
inline Real spring_factor(Real dx, Real dy, Real dz, Real vx, Real vy, Real vz, Real stiffness,
                          Real rest_length, Real damping) {
  const Real length_squared = dx * dx + dy * dy + dz * dz;
  const Real inverse = length_squared > Real(0) ? Real(1) / std::sqrt(length_squared) : Real(0);
  Real factor = stiffness * (Real(1) - rest_length * inverse);
  if constexpr (damped) {
    const Real along = (vx * dx + vy * dy + vz * dz) * inverse;
    factor += damping * along * inverse;
  }
  return factor;
}

/// What springs hold: energy [J], and the largest strain (l - l0) / l0 of those with l0 > 0.
struct SpringMeasure {
  double energy = 0.0;
  double max_strain = 0.0;
  bool any_strain = false;

  void add_spring(double length, double stiffness, double rest_length) {
    const double stretch = length - rest_length;
    energy += 0.5 * stiffness * stretch * stretch;
    if (rest_length > 0.0) add_strain(stretch / rest_length);
  }

  void add(const SpringMeasure& other) {
    energy += other.energy;
    if (other.any_strain) add_strain(other.max_strain);
  }

 private:
  void add_strain(double strain) {
    max_strain = any_strain ? std::fmax(max_strain, strain) : strain;
    any_strain = true;
  }
};

}  // namespace hooke
