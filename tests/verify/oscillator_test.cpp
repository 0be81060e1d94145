#include <doctest/doctest.h>

#include <cmath>
#include <complex>

#include "scenes.h"
#include "verify/method_theory.h"
#include "verify/order.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// A mass on a damped spring from a fixed point, x from the rest length, released at x0 with speed v0.
struct DampedOscillator {
  double mass, stiffness, damping, x0, v0;

  Scene scene() const {
    Scene scene;
    scene.add_particle(1.0, {0, 0, 0});
    scene.pin(0);
    scene.add_particle(mass, {2.0 + x0, 0, 0}, {v0, 0, 0});
    scene.add_spring(0, 1, stiffness, 2.0, damping);
    return scene;
  }

  /// The exact motion: x'' + 2 zeta w x' + w^2 x = 0.
  double exact(double t) const {
    const double w = std::sqrt(stiffness / mass), zeta = damping / (2.0 * std::sqrt(stiffness * mass));
    if (zeta == 1.0) return (x0 + (v0 + w * x0) * t) * std::exp(-w * t);
    const std::complex<double> root = std::sqrt(std::complex<double>(zeta * zeta - 1.0));
    const std::complex<double> a = w * (-zeta + root), b = w * (-zeta - root);
    return (((v0 - b * x0) * std::exp(a * t) + (a * x0 - v0) * std::exp(b * t)) / (a - b)).real();
  }

  double error(const Method& method, double h, double t, Accumulation accumulation) const {
    Simulation<double> simulation(scene(), {.method = method, .step = h, .accumulation = accumulation});
    REQUIRE(simulation.step(std::uint64_t(std::lround(t / h))).ok());
    return std::abs(position(simulation, 1).x() - 2.0 - exact(t));
  }
};

}  // namespace

TEST_CASE("damped oscillator: each method converges to the closed form with its order, in three regimes") {
  const DampedOscillator under{0.5, 32.0, 0.8, 0.3, 0.1}, critical{0.5, 32.0, 8.0, 0.3, 0.1},
      over{0.5, 32.0, 16.0, 0.3, 0.1};
  for (const auto& [regime, oscillator] :
       {std::pair{std::string("under"), under}, {"critical", critical}, {"over", over}}) {
    for (const MethodTheory& theory : methods()) {
      CAPTURE(theory.name());
      const int order = theory.order_with_damping();
      for (auto accumulation : accumulations) {
        std::vector<double> errors;
        for (double h = order == 4 ? 2e-2 : 1e-3; errors.size() < 5; h /= 2.0)
          errors.push_back(oscillator.error(theory.method, h, 1.0, accumulation));
        CHECK(std::abs(order_of(errors) - order) < 0.1);
        CHECK(errors.back() < (order == 1 ? 1e-3 : order == 2 ? 1e-6 : 1e-9));
        if (accumulation == Accumulation::gather)
          MESSAGE(theory.name() << ", damping " << regime << ": order " << order_of(errors) << ", last error "
                                << errors.back() << " m");
      }
    }
  }
}

TEST_CASE("damping lies along the spring: motion across it is not damped") {
  Scene scene;
  scene.add_particle(1.0, {0, 0, 0}, {0, -1, 0});
  scene.add_particle(1.0, {1, 0, 0}, {0, 1, 0});
  scene.add_spring(0, 1, 0.0, 1.0, 10.0);
  Simulation<double> simulation(scene, {.method = ExplicitEuler{}, .step = 1e-3});
  REQUIRE(simulation.step().ok());
  CHECK(velocity(simulation, 0) == Vec3(0, -1, 0));
  CHECK(velocity(simulation, 1) == Vec3(0, 1, 0));
}

TEST_CASE("damped explicit Euler is stable up to h = 2 zeta / w and no further") {
  const double mass = 1.0, stiffness = 100.0, zeta = 0.05, w = 10.0;
  const DampedOscillator oscillator{mass, stiffness, 2.0 * zeta * std::sqrt(stiffness * mass), 0.1, 0.0};
  const auto growth = [&](double h) {
    Simulation<double> simulation(oscillator.scene(), {.method = ExplicitEuler{}, .step = h});
    const double before = simulation.energy().total();
    REQUIRE(simulation.step(20'000).ok());
    return simulation.energy().total() / before;
  };
  CHECK(growth(0.99 * 2.0 * zeta / w) < 0.5);
  CHECK(growth(1.01 * 2.0 * zeta / w) > 2.0);
}

TEST_CASE(
    "symplectic Euler and Verlet are stable up to h = (2 / w) (sqrt(1 + zeta^2) - zeta) and no further") {
  const double mass = 1.0, stiffness = 100.0, w = 10.0;
  for (double zeta : {0.0, 0.1, 1.0}) {
    const DampedOscillator oscillator{mass, stiffness, 2.0 * zeta * std::sqrt(stiffness * mass), 0.01, 0.0};
    const double limit = 2.0 / w * (std::sqrt(1.0 + zeta * zeta) - zeta);
    const auto energy_after = [&](const Method& method, double h) {
      Simulation<double> simulation(oscillator.scene(),
                                    {.method = method, .step = h, .unstable_step = UnstableStep::take});
      const double before = simulation.energy().total();
      REQUIRE(simulation.step(400).ok());
      return simulation.energy().total() / before;
    };
    for (const Method& method : {Method(SymplecticEuler{}), Method(Verlet{})}) {
      // Near the limit the undamped energy of the discrete motion swings, but stays bounded.
      CHECK(energy_after(method, 0.99 * limit) < 200.0);
      CHECK(energy_after(method, 1.01 * limit) > 1e3);
    }
  }
}
