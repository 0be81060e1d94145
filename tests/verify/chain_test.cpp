#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

TEST_CASE("a vertical chain at rest: spring i of N carries N - i + 1 masses") {
  const int n = 8;
  const double mass = 0.05, stiffness = 200.0, rest = 0.1, g = 9.81;
  Scene scene;
  for (int i = 0; i <= n; ++i) scene.add_particle(mass, {0, -rest * i, 0});
  for (Index i = 0; i < Index(n); ++i) scene.add_spring(i, i + 1, stiffness, rest, 0.05);
  scene.pin(0);
  scene.effects = {Gravity{}, Drag{0.2}};
  Simulation<double> simulation(scene, {.step = 1e-3});
  REQUIRE(simulation.step(60'000).ok());
  for (int i = 1; i <= n; ++i) {
    const double length = position(simulation, Index(i) - 1).y() - position(simulation, Index(i)).y();
    CHECK(length - rest == doctest::Approx((n - i + 1) * mass * g / stiffness).epsilon(1e-9));
  }
  CHECK(simulation.max_strain() == doctest::Approx(n * mass * g / stiffness / rest).epsilon(1e-9));
}

TEST_CASE(
    "a chain of N masses between fixed ends swings along itself at 2 sqrt(k / m) sin(j pi / (2 (N + 1)))") {
  const int n = 11;
  const double mass = 0.3, stiffness = 70.0, h = 1e-3, amplitude = 1e-3;
  for (int j : {1, 4, 11}) {
    Scene scene;
    const auto shape = [&](int i) { return std::sin(i * j * std::numbers::pi / (n + 1)); };
    for (int i = 0; i <= n + 1; ++i) scene.add_particle(mass, {i + amplitude * shape(i), 0, 0});
    for (Index i = 0; i <= Index(n); ++i) scene.add_spring(i, i + 1, stiffness, 1.0);
    scene.pin(0);
    scene.pin(Index(n) + 1);
    const double w = 2.0 * std::sqrt(stiffness / mass) * std::sin(j * std::numbers::pi / (2.0 * (n + 1)));
    // Symplectic Euler turns by theta each step; from rest at step 0 its positions are cos((n + 1/2) theta) /
    // cos(theta / 2).
    const double theta = 2.0 * std::asin(h * w / 2.0);
    Simulation<double> simulation(scene, {.step = h});
    for (int step = 1; step <= 2000; ++step) {
      REQUIRE(simulation.step().ok());
      const double exact = amplitude * std::cos((step + 0.5) * theta) / std::cos(theta / 2.0);
      const double measured = position(simulation, 3).x() - 3.0;
      REQUIRE(std::abs(measured - exact * shape(3)) < 1e-9 * amplitude);
    }
  }
}

TEST_CASE("an elastic chain hangs between level supports as its closed form says") {
  // N links and N - 1 masses: V_i = W / 2 - i m g, T_i = hypot(H, V_i), link length l0 + T_i / k; H from the
  // span.
  const int n = 20;
  const double mass = 0.05, stiffness = 1e4, rest = 0.06, span = 1.0;
  const double published_sag = 0.3002856492;
  Scene scene;
  for (int i = 0; i <= n; ++i) {
    const double s = double(i) / n;
    scene.add_particle(mass, {span * s, -1.2 * s * (1.0 - s), 0});
  }
  for (Index i = 0; i < Index(n); ++i) scene.add_spring(i, i + 1, stiffness, rest, 1.0);
  scene.pin(0);
  scene.pin(Index(n));
  scene.effects = {Gravity{}, Drag{0.15}};
  Simulation<double> simulation(scene, {.step = 1e-3});
  REQUIRE(simulation.step(100'000).ok());
  CHECK(-position(simulation, n / 2).y() == doctest::Approx(published_sag).epsilon(1e-8));
}
