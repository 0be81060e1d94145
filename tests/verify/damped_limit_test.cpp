// How long a step may be where there is damping.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "verify/step_matrix.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// The largest stable h w that the engine's steps have.
double measured_limit(const Method& method, double zeta) {
  return stability_limit([&](double z, double ratio) { return measured_step(method, z, ratio); }, zeta);
}

}  // namespace

TEST_CASE("Euler's and Verlet's largest damped steps meet their formulas") {
  for (double zeta : {0.01, 0.1, 0.5, 0.9, 1.5, 3.0}) {
    CAPTURE(zeta);
    // Overdamped, the faster of two decays sets the limit.
    const double explicit_limit = zeta <= 1.0 ? 2.0 * zeta : 2.0 / (zeta + std::sqrt(zeta * zeta - 1.0));
    CHECK(measured_limit(ExplicitEuler{}, zeta) == doctest::Approx(explicit_limit).epsilon(1e-6));
    const double splitting_limit = 2.0 * (std::sqrt(1.0 + zeta * zeta) - zeta);
    CHECK(measured_limit(SymplecticEuler{}, zeta) == doctest::Approx(splitting_limit).epsilon(1e-6));
    MESSAGE("zeta " << zeta << ": explicit Euler " << measured_limit(ExplicitEuler{}, zeta) << " (formula "
                    << explicit_limit << "), symplectic Euler " << measured_limit(SymplecticEuler{}, zeta)
                    << " (formula " << splitting_limit << ")");
  }
}

TEST_CASE("Runge-Kutta's largest damped steps are the published ones") {
  const struct {
    double zeta, midpoint, runge_kutta_4;
  } published[] = {{0.01, 0.44, 2.85}, {0.1, 1.05, 2.95}, {0.5, 2.0, 2.62}, {1.0, 2.0, 2.785}};
  for (const auto& row : published) {
    CAPTURE(row.zeta);
    const double two = measured_limit(Midpoint{}, row.zeta), four = measured_limit(RungeKutta4{}, row.zeta);
    CHECK(std::abs(two - row.midpoint) < 0.0051);  // as many digits as are published
    CHECK(std::abs(measured_limit(Heun{}, row.zeta) - two) < 1e-6);
    CHECK(std::abs(four - row.runge_kutta_4) < 0.0051);
    MESSAGE("zeta " << row.zeta << ": midpoint " << two << " (published " << row.midpoint << "), RK4 " << four
                    << " (published " << row.runge_kutta_4 << ")");
  }
}

TEST_CASE("a network with Rayleigh damping a M + b K bears explicit Euler up to h = b + a / w_max^2") {
  // A chain of n masses between fixed ends, moving along itself. Every mode is underdamped.
  const int n = 12;
  const double mass = 0.2, stiffness = 50.0, a = 2.0, b = 0.01;
  const double w_max = 2.0 * std::sqrt(stiffness / mass) * std::sin(n * std::numbers::pi / (2.0 * (n + 1)));
  REQUIRE(0.5 * (a / w_max + b * w_max) < 1.0);
  Scene scene;
  for (int i = 0; i <= n + 1; ++i) scene.add_particle(mass, {i + (i == 4 ? 1e-3 : 0.0), 0, 0});
  for (Index i = 0; i <= Index(n); ++i) scene.add_spring(i, i + 1, stiffness, 1.0, b * stiffness);
  scene.pin(0);
  scene.pin(Index(n) + 1);
  scene.effects = {Drag{a * mass}};
  const auto growth = [&](double h) {
    Simulation<double> simulation(
        scene, {.method = ExplicitEuler{}, .step = h, .unstable_step = UnstableStep::take, .threads = 1});
    const double before = simulation.energy().total();
    REQUIRE(simulation.step(20'000).ok());
    return simulation.energy().total() / before;
  };
  const double limit = b + a / (w_max * w_max), below = growth(0.99 * limit), above = growth(1.01 * limit);
  CHECK(below < 1e-3);
  CHECK(above > 1e3);
  MESSAGE("energy after 20000 steps at 0.99 and 1.01 of the limit: " << below << ", " << above
                                                                     << " times that at the start");
}
