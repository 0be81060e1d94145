#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "scenes.h"
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

TEST_CASE("two bodies on a spring swing at sqrt(k / mu), with order 1") {
  const double w = std::sqrt(stiffness / mu), t = 2.0;
  for (const Method& method : {Method(ExplicitEuler{}), Method(SymplecticEuler{})}) {
    std::vector<double> errors;
    for (double h = 5e-4; h > 5e-5; h /= 2.0) {
      Simulation<double> simulation(pair(0.2, {0.3, -0.1, 0.0}), {.method = method, .step = h});
      REQUIRE(simulation.step(std::uint64_t(std::lround(t / h))).ok());
      const double length = (position(simulation, 1) - position(simulation, 0)).norm();
      errors.push_back(std::abs(length - rest - 0.2 * std::cos(w * t)));
    }
    CHECK(order_of(errors) == doctest::Approx(1.0).epsilon(0.05));
    CHECK(errors.back() < 2e-2);
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
  const double h = 1e-5;
  Simulation<double> simulation(scene, {.step = h});
  const auto steps = std::uint64_t(std::lround(2.0 * std::numbers::pi / rate / h));
  REQUIRE(simulation.step(steps).ok());
  CHECK((position(simulation, 1) - position(simulation, 0)).norm() == doctest::Approx(length).epsilon(1e-4));
  CHECK((position(simulation, 1) - Vec3(r2, 0, 0)).norm() < 1e-3);  // one whole turn
}
