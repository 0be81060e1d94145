// The exact results of the discrete methods, not only of the equations: a wrong sign passes a test of the
// order, but not a comparison to 1e-12.

#include <doctest/doctest.h>

#include <cmath>

#include "scenes.h"
#include "verify/method_theory.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double tolerance = 1e-12;

bool near(double value, double exact) {
  return std::abs(value - exact) <= tolerance * std::abs(exact);
}

Simulation<double> projectile(const Method& method, double h, std::uint64_t steps) {
  Scene scene;
  scene.add_particle(3.0, {1.0, 2.0, -1.0}, {10.0, 15.0, 0.5});
  scene.effects = {Gravity{}};
  Simulation<double> simulation(scene, {.method = method, .step = h});
  REQUIRE(simulation.step(steps).ok());
  return simulation;
}

/// v^2 + w^2 x^2, twice the energy per mass, of an oscillator with k / m = w^2, its length counted from rest.
double energy(const Simulation<double>& simulation) {
  return simulation.energy().total();
}

Scene oscillator(double mass, double stiffness) {
  Scene scene;
  scene.add_particle(1.0, {0, 0, 0});
  scene.pin(0);
  scene.add_particle(mass, {1.3, 0, 0}, {0.4, 0, 0});
  scene.add_spring(0, 1, stiffness, 0.0);
  return scene;
}

/// Step by step to round-off for a hundred steps, and to 1e-9 over a million.
template <class Invariant>
void check_kept_for_a_million_steps(Simulation<double>& simulation, const Invariant& invariant) {
  const double start = invariant();
  for (int n = 0; n < 100; ++n) {
    REQUIRE(simulation.step().ok());
    REQUIRE(near(invariant(), start));
  }
  REQUIRE(simulation.step(1'000'000 - 100).ok());
  CHECK(std::abs(invariant() - start) < 1e-9 * start);
  MESSAGE("changed by " << invariant() / start - 1.0 << " of itself");
}

}  // namespace

TEST_CASE("x' = 2 t: explicit Euler gives t^2 - h t") {
  // v' = 2 from rest makes v = 2 t exact, and x' = v the lecture's equation.
  const double h = 0.01;
  Scene scene = one_particle();
  scene.effects = {Gravity{{2.0, 0.0, 0.0}}};
  Simulation<double> simulation(scene, {.method = ExplicitEuler{}, .step = h});
  for (int n = 1; n <= 1000; ++n) {
    REQUIRE(simulation.step().ok());
    const double t = n * h;
    REQUIRE(near(velocity(simulation, 0).x(), 2.0 * t));
    REQUIRE(std::abs(position(simulation, 0).x() - (t * t - h * t)) <= tolerance * t * t);
  }
}

TEST_CASE("x' = 2 t: methods of order 2 and more give t^2") {
  Scene scene = one_particle();
  scene.effects = {Gravity{{2.0, 0.0, 0.0}}};
  for (const MethodTheory& theory : methods()) {
    if (theory.order < 2) continue;
    CAPTURE(theory.name());
    Simulation<double> simulation(scene, {.method = theory.method, .step = 0.01});
    for (int n = 1; n <= 1000; ++n) {
      REQUIRE(simulation.step().ok());
      const double t = n * 0.01;
      REQUIRE(near(velocity(simulation, 0).x(), 2.0 * t));
      REQUIRE(near(position(simulation, 0).x(), t * t));
    }
  }
}

TEST_CASE(
    "projectile: explicit Euler falls behind by g h t / 2, symplectic Euler runs ahead, others are exact") {
  const double h = 0.02, t = 100 * h, g = -9.81;
  const Vec3 start(1.0, 2.0, -1.0), speed(10.0, 15.0, 0.5);
  for (const MethodTheory& theory : methods()) {
    CAPTURE(theory.name());
    const double sign = theory.order > 1 ? 0.0 : theory.splitting ? 1.0 : -1.0;
    const auto simulation = projectile(theory.method, h, 100);
    const Vec3 x = position(simulation, 0);
    CHECK(near(x.x(), start.x() + speed.x() * t));
    CHECK(near(x.y(), start.y() + speed.y() * t + 0.5 * g * t * t + sign * 0.5 * g * h * t));
    CHECK(near(x.z() + 3.0, start.z() + speed.z() * t + 3.0));
    CHECK(near(velocity(simulation, 0).y(), speed.y() + g * t));
  }
}

TEST_CASE("undamped oscillator: explicit Euler multiplies the energy by 1 + (h w)^2 each step") {
  const double mass = 0.7, stiffness = 31.0, h = 0.01;
  const double z2 = h * h * stiffness / mass;
  for (auto accumulation : accumulations) {
    const Settings settings{.method = ExplicitEuler{}, .step = h, .accumulation = accumulation};
    Simulation<double> simulation(oscillator(mass, stiffness), settings);
    for (int n = 0; n < 500; ++n) {
      const double before = energy(simulation);
      REQUIRE(simulation.step().ok());
      REQUIRE(near(energy(simulation), (1.0 + z2) * before));
    }
  }
}

TEST_CASE("undamped oscillator: symplectic Euler keeps v^2 + w^2 x^2 - h w^2 x v over a million steps") {
  const double mass = 0.7, stiffness = 31.0, h = 0.01, w2 = stiffness / mass;
  Simulation<double> simulation(oscillator(mass, stiffness), {.step = h});
  const auto invariant = [&] {
    const double x = position(simulation, 1).x(), v = velocity(simulation, 1).x();
    return v * v + w2 * x * x - h * w2 * x * v;
  };
  check_kept_for_a_million_steps(simulation, invariant);
}

TEST_CASE("undamped oscillator: Verlet keeps v^2 + w^2 (1 - (h w)^2 / 4) x^2 over a million steps") {
  const double mass = 0.7, stiffness = 31.0, h = 0.1, w2 = stiffness / mass;
  Simulation<double> simulation(oscillator(mass, stiffness), {.method = Verlet{}, .step = h});
  const auto invariant = [&] {
    const double x = position(simulation, 1).x(), v = velocity(simulation, 1).x();
    return v * v + w2 * (1.0 - 0.25 * h * h * w2) * x * x;
  };
  check_kept_for_a_million_steps(simulation, invariant);
}

TEST_CASE("undamped oscillator: symplectic Euler turns by 2 asin(h w / 2) each step") {
  const double mass = 0.7, stiffness = 31.0, h = 0.05, w = std::sqrt(stiffness / mass);
  const double theta = 2.0 * std::asin(h * w / 2.0);
  Simulation<double> simulation(oscillator(mass, stiffness), {.step = h});
  // x_n = a cos(n theta) + b sin(n theta), from x_0 and x_1.
  const double x0 = position(simulation, 1).x();
  REQUIRE(simulation.step().ok());
  const double b = (position(simulation, 1).x() - x0 * std::cos(theta)) / std::sin(theta);
  for (int n = 2; n <= 200; ++n) {
    REQUIRE(simulation.step().ok());
    const double exact = x0 * std::cos(n * theta) + b * std::sin(n * theta);
    REQUIRE(std::abs(position(simulation, 1).x() - exact) < 1e-11 * std::hypot(x0, b));
  }
}

TEST_CASE("drag: explicit Euler multiplies the distance to the terminal velocity by 1 - c h / m") {
  const double mass = 2.0, c = 3.0, h = 0.01;
  Scene scene;
  scene.add_particle(mass, Vec3::Zero(), {5.0, 1.0, 0.0});
  scene.effects = {Gravity{}, Drag{c}};
  const Vec3 terminal = mass / c * Vec3(0, -9.81, 0), start(5.0, 1.0, 0.0);
  for (const Method& method : {Method(ExplicitEuler{}), Method(SymplecticEuler{})}) {
    Simulation<double> simulation(scene, {.method = method, .step = h});
    REQUIRE(simulation.step(150).ok());
    const Vec3 exact = terminal + std::pow(1.0 - c * h / mass, 150) * (start - terminal);
    CHECK((velocity(simulation, 0) - exact).norm() <= tolerance * exact.norm());
  }
}
