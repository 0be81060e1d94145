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
  const std::size_t begin = strip.first / block_size;
  for_each_corner(slots, begin, begin + strip.lanes / block_size, [&](const ElementCorner<Real>& corner) {
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
    const std::size_t lane = corner.own - strip.first;
    blocks.xx[lane] += Real(derivative.across + most * n.x() * n.x());
    blocks.xy[lane] += Real(most * n.x() * n.y());
    blocks.xz[lane] += Real(most * n.x() * n.z());
    blocks.yy[lane] += Real(derivative.across + most * n.y() * n.y());
    blocks.yz[lane] += Real(most * n.y() * n.z());
    blocks.zz[lane] += Real(derivative.across + most * n.z() * n.z());
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
