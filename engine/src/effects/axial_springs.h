#pragma once

#include "force_derivative.h"
#include "model/element_slots.h"
#include "strip.h"

/// What effects that are springs of two particles have in common where speed matters little.

namespace hooke {

/// The weighted derivative of a spring's tension T: T' along it, T / l across it. For blocks none may be < 0.
struct AxialDerivative {
  double along = 0.0, across = 0.0;  ///< [N/m], times the weight
};

template <class Real, class Visit>
void for_each_spring_end(const ElementSlots<Real>& slots, const Strip<Real>& strip, const Visit& visit) {
  for_each_corner(slots, strip, [&](const ElementCorner<Real>& corner) {
    const auto at = [&](std::size_t c) -> Vec3 {
      return strip.state.position(corner.particles[c]).template cast<double>();
    };
    visit(corner, Vec3(at(0) - at(1)));
  });
}

/// derivative_of(ElementCorner, length) is a spring's AxialDerivative.
template <class Real, class DerivativeOf>
void add_axial_blocks(const ElementSlots<Real>& slots, const Strip<Real>& strip,
                      const DerivativeOf& derivative_of, StripBlocks<Real>& blocks) {
  for_each_spring_end(slots, strip, [&](const ElementCorner<Real>& corner, const Vec3& apart) {
    const double length = apart.norm();
    if (length == 0.0) return;
    const AxialDerivative derivative = derivative_of(corner, length);
    const Vec3 n = apart / length;
    const double most = derivative.along - derivative.across;
    const Eigen::Matrix3d own = derivative.across * Eigen::Matrix3d::Identity() + most * n * n.transpose();
    add_matrix(own, corner.own - strip.first, blocks);
  });
}

/// energy_of(ElementCorner, length) is a spring's energy [J]; each end has half of it.
template <class Real, class EnergyOf>
double axial_energy(const ElementSlots<Real>& slots, const Strip<Real>& strip, const EnergyOf& energy_of) {
  double sum = 0.0;
  for_each_spring_end(slots, strip, [&](const ElementCorner<Real>& corner, const Vec3& apart) {
    sum += 0.5 * energy_of(corner, apart.norm());
  });
  return sum;
}

}  // namespace hooke
