#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "scenes.h"
#include "verify/method_theory.h"
#include "verify/order.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double m1 = 0.6, m2 = 1.9, stiffness = 40.0, rest = 1.0;
constexpr double mu = m1 * m2 / (m1 + m2);

Scene pair(double stretch, const Vec3& drift) {
  Scene scene;
  scene.add_particle(m1, {0, 0, 0}, drift);
  scene.add_particle(m2, {rest + stretch, 0, 0}, drift);
  scene.add_spring(0, 1, stiffness, rest);
  return scene;
}

}  // namespace

TEST_CASE("two bodies on a spring swing at sqrt(k / mu), with each method's order") {
  const double w = std::sqrt(stiffness / mu), t = 2.1;
  for (const MethodTheory& theory : methods()) {
    CAPTURE(theory.name());
    std::vector<double> errors;
    for (double h = theory.order == 4 ? 1e-2 : 5e-4; errors.size() < 4; h /= 2.0) {
      Simulation<double> simulation(pair(0.2, {0.3, -0.1, 0.0}), {.method = theory.method, .step = h});
      REQUIRE(simulation.step(std::uint64_t(std::lround(t / h))).ok());
      const double length = (position(simulation, 1) - position(simulation, 0)).norm();
      errors.push_back(std::abs(length - rest - 0.2 * std::cos(w * t)));
    }
    CHECK(std::abs(order_of(errors) - theory.order) < 0.1);
    CHECK(errors.back() < (theory.order == 1 ? 2e-2 : 1e-6));
    MESSAGE(theory.name() << ": order " << order_of(errors) << ", last error " << errors.back() << " m");
  }
}

TEST_CASE("the centre of mass moves as a free body") {
  const Vec3 drift(0.3, -0.1, 0.7);
  Simulation<double> simulation(pair(0.2, drift), {.step = 1e-3});
  REQUIRE(simulation.step(2000).ok());
  const Vec3 centre = (m1 * position(simulation, 0) + m2 * position(simulation, 1)) / (m1 + m2);
  const Vec3 start = m2 * Vec3(1.2, 0, 0) / (m1 + m2);
  CHECK((centre - (start + 2.0 * drift)).norm() < 1e-12);
}

TEST_CASE("a pair that turns at rate W keeps the length k l0 / (k - mu W^2)") {
  const double rate = 3.0, length = stiffness * rest / (stiffness - mu * rate * rate);
  Scene scene;
  const double r1 = length * m2 / (m1 + m2), r2 = length * m1 / (m1 + m2);
  scene.add_particle(m1, {-r1, 0, 0}, {0, -rate * r1, 0});
  scene.add_particle(m2, {r2, 0, 0}, {0, rate * r2, 0});
  scene.add_spring(0, 1, stiffness, rest);
  const std::uint64_t steps = 20'000;
  for (const MethodTheory& theory : methods()) {
    CAPTURE(theory.name());
    Simulation<double> simulation(
        scene, {.method = theory.method, .step = 2.0 * std::numbers::pi / rate / double(steps)});
    REQUIRE(simulation.step(steps).ok());
    const double tolerance = theory.order == 1 ? 5e-3 : theory.order == 2 ? 1e-6 : 1e-11;
    CHECK((position(simulation, 1) - position(simulation, 0)).norm() ==
          doctest::Approx(length).epsilon(tolerance));
    CHECK((position(simulation, 1) - Vec3(r2, 0, 0)).norm() < tolerance);  // one whole turn
  }
}
