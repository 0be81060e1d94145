#pragma once

#include <cmath>

namespace hooke {

/// What springs hold: energy [J], and the largest strain (l - l0) / l0 of those with stiffness and l0 > 0.
struct SpringMeasure {
  double energy = 0.0;
  double max_strain = 0.0;
  bool any_strain = false;

  /// A spring of a length [m], a stiffness [N/m] and their product with the rest length: the pull k l0 [N].
  void add_spring(double length, double stiffness, double pull) {
    if (!(stiffness > 0.0)) return;
    const double rest_length = pull / stiffness, stretch = length - rest_length;
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
