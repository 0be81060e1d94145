#pragma once

#include <vector>

#include <hooke/methods.h>

namespace hooke {

/// An explicit Runge-Kutta method: stage i is at y + h sum_j a[i][j] k_j, the result at y + h sum_j b[j] k_j,
/// each k_j the derivative at stage j (Butcher 1964).
struct ButcherTableau {
  std::vector<std::vector<double>> a;  ///< row i has i entries
  std::vector<double> b;

  std::size_t stages() const { return b.size(); }
};

ButcherTableau tableau(const ExplicitEuler&);
ButcherTableau tableau(const Midpoint&);
ButcherTableau tableau(const Heun&);
ButcherTableau tableau(const RungeKutta4&);
ButcherTableau tableau(const DormandPrince&);

/// A state made of the accelerations A_j of earlier stages:
///   x + time h v + h^2 sum_j position[j] A_j and v + h sum_j velocity[j] A_j.
struct NystromRow {
  double time = 0.0;                       ///< share of the step at which it is [1]
  std::vector<double> position, velocity;  ///< [1], equally many
};

/// The method for x'' = a(t, x, x'), with the velocities of the stages put into the positions (Nystrom 1925):
/// exactly the same method, but it keeps only accelerations. Row i is what is computed as soon as stage i's
/// accelerations are known: where the next stage is, and last the result.
std::vector<NystromRow> nystrom_rows(const ButcherTableau& tableau);

/// The difference of the results of order 5 and 4 of Dormand and Prince, in the accelerations of the six
/// stages and of the result. Its `time` is 0.
NystromRow dormand_prince_error();

}  // namespace hooke
