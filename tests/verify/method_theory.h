#pragma once

#include <cmath>
#include <initializer_list>
#include <string>
#include <vector>

#include <hooke/methods.h>
#include <Eigen/LU>

/// What theory says of each method, from the literature and not from the engine.

namespace hooke::test {

/// What one step does to (w x, v) of a linear oscillator x'' = -w^2 x - 2 zeta w x'.
using StepMatrix = Eigen::Matrix2d;

/// A kick v += share h a, as a matrix; z = h w.
inline StepMatrix kick(double share, double z, double zeta) {
  return StepMatrix{{1.0, 0.0}, {-share * z, 1.0 - 2.0 * zeta * share * z}};
}

/// A drift x += share h v.
inline StepMatrix drift(double share, double z) {
  return StepMatrix{{1.0, share * z}, {0.0, 1.0}};
}

/// h times the derivative of (w x, v) by time.
inline StepMatrix derivative_by_time(double z, double zeta) {
  return StepMatrix{{0.0, z}, {-z, -2.0 * zeta * z}};
}

/// A Runge-Kutta step: its stability polynomial, whose coefficients are given from the lowest.
inline StepMatrix polynomial(std::initializer_list<double> coefficients, double z, double zeta) {
  const StepMatrix one_step = derivative_by_time(z, zeta);
  StepMatrix power = StepMatrix::Identity(), sum = StepMatrix::Zero();
  for (double coefficient : coefficients) {
    sum += coefficient * power;
    power = one_step * power;
  }
  return sum;
}

/// SRKN6b of Blanes and Moan 2002, their table 3: kicks b, drifts a, symmetric.
inline StepMatrix blanes_moan(double z, double zeta) {
  const double b1 = 0.0829844064174052, b2 = 0.396309801498368, b3 = -0.0390563049223486;
  const double a1 = 0.245298957184271, a2 = 0.604872665711080;
  const double b[] = {b1, b2, b3, 1.0 - 2.0 * (b1 + b2 + b3), b3, b2, b1};
  const double a[] = {a1, a2, 0.5 - a1 - a2, 0.5 - a1 - a2, a2, a1};
  StepMatrix step = kick(b[0], z, zeta);
  for (int i = 0; i < 6; ++i) step = kick(b[i + 1], z, zeta) * drift(a[i], z) * step;
  return step;
}

struct MethodTheory {
  Method method;
  bool splitting;  ///< into kicks and drifts: then it conserves areas and momenta
  int order;       ///< where forces depend on positions and time alone
  int evaluations;
  StepMatrix (*step)(double z, double zeta);

  /// A kick sees the velocity at its beginning, so splitting methods are of order 1 in damping.
  int order_with_damping() const { return splitting ? 1 : order; }
  std::string name() const { return std::string(to_string(method)); }
};

/// The explicit methods with steps of one length.
inline std::vector<MethodTheory> methods() {
  const auto runge_kutta_2 = [](double z, double zeta) { return polynomial({1, 1, 1.0 / 2}, z, zeta); };
  return {
      {SymplecticEuler{}, true, 1, 1,
       [](double z, double zeta) -> StepMatrix { return drift(1, z) * kick(1, z, zeta); }},
      {ExplicitEuler{}, false, 1, 1,
       [](double z, double zeta) {
         return polynomial({1, 1}, z, zeta);
       }},
      {Midpoint{}, false, 2, 2, runge_kutta_2},
      {Heun{}, false, 2, 2, runge_kutta_2},
      {RungeKutta4{}, false, 4, 4,
       [](double z, double zeta) {
         return polynomial({1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24}, z, zeta);
       }},
      {Verlet{}, true, 2, 1,
       [](double z, double zeta) -> StepMatrix {
         return kick(0.5, z, zeta) * drift(1, z) * kick(0.5, z, zeta);
       }},
      {BlanesMoan{}, true, 4, 6, blanes_moan},
  };
}

/// Methods that solve equations, as far as one step is a matrix, solved to round-off.
inline std::vector<MethodTheory> implicit_methods() {
  return {
      {BackwardEuler{.tolerance = 1e-13}, false, 1, 1,
       [](double z, double zeta) -> StepMatrix {
         return (StepMatrix::Identity() - derivative_by_time(z, zeta)).inverse();
       }},
      {ImplicitMidpoint{.tolerance = 1e-13}, false, 2, 1,
       [](double z, double zeta) -> StepMatrix {
         const StepMatrix half = 0.5 * derivative_by_time(z, zeta);
         return (StepMatrix::Identity() - half).inverse() * (StepMatrix::Identity() + half);
       }},
  };
}

/// Those that conserve areas and momenta, and the others.
inline std::vector<MethodTheory> splitting_methods(bool splitting = true) {
  std::vector<MethodTheory> chosen;
  for (const MethodTheory& theory : methods()) {
    if (theory.splitting == splitting) chosen.push_back(theory);
  }
  return chosen;
}

}  // namespace hooke::test
