#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "scenes.h"
#include "verify/method_theory.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double mass = 0.4, length = 0.7, gravity = 9.81;

double arithmetic_geometric_mean(double a, double b) {
  while (std::abs(a - b) > 1e-15 * a) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  return a;
}

/// The period [s] of a rigid pendulum that swings up to `angle`.
double rigid_period(double angle) {
  return 2.0 * std::numbers::pi * std::sqrt(length / gravity) /
         arithmetic_geometric_mean(1.0, std::cos(0.5 * angle));
}

/// The pendulum's rod is a spring; it starts at rest at `angle`, stretched by the pull that it has there.
Scene pendulum(double angle, double stiffness) {
  const double l = length + mass * gravity * std::cos(angle) / stiffness;
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  scene.pin(0);
  scene.add_particle(mass, {l * std::sin(angle), -l * std::cos(angle), 0});
  scene.add_spring(0, 1, stiffness, length);
  scene.effects = {Gravity{{0.0, -gravity, 0.0}}};
  return scene;
}

/// When x crosses zero within a step, as a share of it: where the cubic does that has the step's ends and
/// speeds.
double crossing(double x0, double v0, double x1, double v1, double h) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double s = 0.5 * (low + high);
    const double x = (1 + 2 * s) * (1 - s) * (1 - s) * x0 + s * (1 - s) * (1 - s) * h * v0 +
                     s * s * (3 - 2 * s) * x1 - s * s * (1 - s) * h * v1;
    ((x > 0.0) == (x0 > 0.0) ? low : high) = s;
  }
  return low;
}

/// The time [s] between two passages through the lowest point in the same direction.
double measured_period(const Method& method, double angle, double stiffness) {
  const double h = 0.2 / std::sqrt(stiffness / mass);
  Simulation<double> simulation(pendulum(angle, stiffness), {.method = method, .step = h, .threads = 1});
  std::vector<double> passages;
  double x = position(simulation, 1).x(), v = 0.0;
  while (passages.size() < 3) {
    REQUIRE(simulation.step().ok());
    const double next_x = position(simulation, 1).x(), next_v = velocity(simulation, 1).x();
    if ((next_x > 0.0) != (x > 0.0))
      passages.push_back(h * (double(simulation.steps() - 1) + crossing(x, v, next_x, next_v, h)));
    x = next_x;
    v = next_v;
  }
  return passages[2] - passages[0];
}

}  // namespace

TEST_CASE(
    "a pendulum's period is the rigid one's by the arithmetic-geometric mean, in the limit of a stiff rod") {
  for (const Method& method : {Method(SymplecticEuler{}), Method(Verlet{}), Method(RungeKutta4{})}) {
    for (double degrees : {10.0, 60.0, 120.0}) {
      const double angle = degrees / 180.0 * std::numbers::pi, exact = rigid_period(angle);
      // The weight stretches the rod by 1e-5 of itself; what that adds to the period goes with 1 / stiffness.
      const double stiffness = 1e5 * mass * gravity / length;
      const double soft = measured_period(method, angle, stiffness),
                   stiff = measured_period(method, angle, 2.0 * stiffness), rigid = 2.0 * stiff - soft;
      CAPTURE(degrees);
      CHECK(std::abs(soft / exact - 1.0) < 3e-5);
      CHECK(std::abs(rigid / exact - 1.0) < 1e-8);
      MESSAGE(to_string(method) << ", " << degrees << " degrees: " << soft / exact - 1.0
                                << " of the period too long, " << rigid / exact - 1.0
                                << " without the rod's stretch; the period is " << exact << " s");
    }
  }
}
