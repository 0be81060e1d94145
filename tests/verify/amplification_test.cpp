// What one step does to an oscillation, against closed forms: a wrong sign or coefficient passes a test of
// the order, but not a comparison to 1e-12.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verify/step_matrix.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// Amplitude and angle after one step of an undamped oscillation, and the leading term of the relative error
/// of its frequency: coefficient z^power.
struct ClosedForm {
  Method method;
  double (*amplitude)(double z);
  double (*angle)(double z);
  double coefficient;
  int power;
};

double kept(double) {
  return 1.0;
}
double leapfrog_angle(double z) {
  return 2.0 * std::asin(0.5 * z);
}
double midpoint_amplitude(double z) {
  return std::sqrt(1.0 + std::pow(z, 4) / 4.0);
}
double midpoint_angle(double z) {
  return std::atan2(z, 1.0 - z * z / 2.0);
}

const ClosedForm closed_forms[] = {
    {SymplecticEuler{}, kept, leapfrog_angle, 1.0 / 24.0, 2},
    {Verlet{}, kept, leapfrog_angle, 1.0 / 24.0, 2},
    {ExplicitEuler{}, [](double z) { return std::hypot(1.0, z); }, [](double z) { return std::atan(z); },
     -1.0 / 3.0, 2},
    {Midpoint{}, midpoint_amplitude, midpoint_angle, 1.0 / 6.0, 2},
    {Heun{}, midpoint_amplitude, midpoint_angle, 1.0 / 6.0, 2},
    {RungeKutta4{}, [](double z) { return std::sqrt(1.0 - std::pow(z, 6) / 72.0 + std::pow(z, 8) / 576.0); },
     [](double z) { return std::atan2(z - std::pow(z, 3) / 6.0, 1.0 - z * z / 2.0 + std::pow(z, 4) / 24.0); },
     -1.0 / 120.0, 4},
};

}  // namespace

TEST_CASE("one step of an oscillator is each method's step matrix to 1e-12, damped or not") {
  double worst = 0.0;
  for (const MethodTheory& theory : methods()) {
    for (auto accumulation : accumulations) {
      for (double z : {0.05, 0.3, 1.0, 1.9}) {
        for (double zeta : {0.0, 0.2, 1.0}) {
          CAPTURE(theory.name());
          CAPTURE(z);
          CAPTURE(zeta);
          const StepMatrix difference =
              measured_step(theory.method, z, zeta, accumulation) - theory.step(z, zeta);
          const double error = difference.cwiseAbs().maxCoeff();
          CHECK(error < 1e-12);
          worst = std::max(worst, error);
        }
      }
    }
  }
  MESSAGE("largest difference of an entry: " << worst);
}

TEST_CASE("amplitude and frequency of an undamped oscillation meet their closed forms to 1e-12") {
  for (const ClosedForm& closed : closed_forms) {
    double worst = 0.0;
    for (double z = 0.05; z < 1.95; z += 0.05) {
      const std::complex<double> eigen = eigenvalue(measured_step(closed.method, z, 0.0));
      const double error = std::max(std::abs(std::abs(eigen) / closed.amplitude(z) - 1.0),
                                    std::abs(std::abs(std::arg(eigen)) / closed.angle(z) - 1.0));
      CHECK(error < 1e-12);
      worst = std::max(worst, error);
    }
    const double z = 0.02;
    const double leading =
        frequency_error(measured_step(closed.method, z, 0.0), z) / std::pow(z, closed.power);
    CHECK(leading == doctest::Approx(closed.coefficient).epsilon(1e-3));
    MESSAGE(to_string(closed.method) << ": amplitude and angle within " << worst << ", frequency error "
                                     << leading << " z^" << closed.power);
  }
}

TEST_CASE("what the methods say of themselves is what theory says, and no method is left out") {
  const auto is_explicit = [](const Method& method) { return !solves_equations(method); };
  const auto explicit_methods = std::count_if(all_methods.begin(), all_methods.end(), is_explicit);
  CHECK(int(methods().size()) + 1 == explicit_methods);  // Dormand and Prince's has no step of its own
  for (const MethodTheory& theory : methods()) {
    CAPTURE(theory.name());
    CHECK(std::visit([](const auto& data) { return data.order; }, theory.method) == theory.order);
    CHECK(std::visit([](const auto& data) { return data.force_evaluations; }, theory.method) ==
          theory.evaluations);
  }
}

TEST_CASE("undamped oscillations stop being stable where the methods say") {
  for (const MethodTheory& theory : methods()) {
    const double stated = std::visit([](const auto& data) { return data.oscillation_limit; }, theory.method);
    // Near its double eigenvalue the largest eigenvalue of an unstable step has only half the digits.
    const double measured =
        stability_limit([&](double z, double zeta) { return measured_step(theory.method, z, zeta); }, 0.0);
    CAPTURE(theory.name());
    CHECK(std::abs(measured - stated) < 1e-4);
    MESSAGE(theory.name() << ": h w <= " << measured);
  }
}

TEST_CASE("at equal cost RK4 overtakes Verlet at 8e-4, and midpoint has 16 times Verlet's error") {
  const auto error = [](const Method& method, double z) {
    return std::abs(frequency_error(measured_step(method, z, 0.0), z));
  };
  // h w of Verlet; methods of more evaluations take steps as much longer.
  double low = 0.01, high = 0.4;
  REQUIRE(error(RungeKutta4{}, 4.0 * low) < error(Verlet{}, low));
  REQUIRE(error(RungeKutta4{}, 4.0 * high) > error(Verlet{}, high));
  while (high - low > 1e-9) {
    const double z = 0.5 * (low + high);
    (error(RungeKutta4{}, 4.0 * z) < error(Verlet{}, z) ? low : high) = z;
  }
  const double crossing = error(Verlet{}, low);
  CHECK(crossing > 8e-4 / 2.0);
  CHECK(crossing < 8e-4 * 2.0);
  const double ratio = error(Midpoint{}, 2.0 * 0.02) / error(Verlet{}, 0.02);
  CHECK(ratio == doctest::Approx(16.0).epsilon(0.01));
  MESSAGE("RK4 and Verlet cross at h w = " << low << ", relative frequency error " << crossing
                                           << "; midpoint / Verlet: " << ratio);
}

TEST_CASE(
    "one step of Dormand and Prince's method is its stability polynomial, where its tolerance allows it") {
  const DormandPrince method{.tolerance = 1e9};
  double worst = 0.0;
  for (double z : {0.05, 0.3, 0.9, 1.9}) {
    for (double zeta : {0.0, 0.2, 1.0}) {
      const StepMatrix exact = polynomial({1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24, 1.0 / 120, 1.0 / 600}, z, zeta);
      worst = std::max(worst, (measured_step(method, z, zeta) - exact).cwiseAbs().maxCoeff());
    }
  }
  CHECK(worst < 1e-12);
  const double limit =
      stability_limit([&](double z, double zeta) { return measured_step(method, z, zeta); }, 0.0);
  CHECK(std::abs(limit - DormandPrince::oscillation_limit) < 3e-4);
  MESSAGE("largest difference of an entry: " << worst << "; h w <= " << limit);
}
