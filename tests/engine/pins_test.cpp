#include <doctest/doctest.h>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

TEST_CASE("a fixed pin stays to the bit, whatever pulls at it") {
  Scene scene = hung_cloth(20, 20);
  scene.particles.velocity.assign(scene.particles.size(), Vec3(1, 2, 3));
  Simulation<double> simulation(scene, {.step = 1e-3});
  CHECK(velocity(simulation, 0).isZero(0.0));
  REQUIRE(simulation.step(500).ok());
  CHECK(position(simulation, 0) == scene.particles.position[0]);
  CHECK(position(simulation, 19) == scene.particles.position[19]);
  CHECK(position(simulation, 200) != scene.particles.position[200]);
}

TEST_CASE("a moving pin follows its keyframes, is held before and after, and has their velocity") {
  Scene scene = one_particle();
  scene.particles.position[0] = {5, 0, 0};
  scene.pin(0, {{0.1, {1, 0, 0}}, {0.3, {1, 4, 0}}, {0.4, {0, 0, 0}}});
  scene.effects = {Gravity{}};
  Simulation<double> simulation(scene, {.step = 0.01});
  const auto expected = [](double t) -> Vec3 {
    if (t < 0.1) return {6, 0, 0};
    if (t < 0.3) return {6, 20 * (t - 0.1), 0};
    if (t < 0.4) return Vec3(5, 0, 0) + (0.4 - t) / 0.1 * Vec3(1, 4, 0);
    return {5, 0, 0};
  };
  CHECK(position(simulation, 0).isApprox(expected(0.0)));
  for (int n = 1; n <= 60; ++n) {
    REQUIRE(simulation.step().ok());
    CHECK((position(simulation, 0) - expected(simulation.time())).norm() < 1e-12);
  }
  simulation.restore(Simulation<double>(scene, {.step = 0.01}).snapshot());
  REQUIRE(simulation.step(20).ok());
  CHECK(velocity(simulation, 0).isApprox(Vec3(0, 20, 0)));
}

TEST_CASE("a particle on a spring feels its pin move") {
  Scene scene = one_particle();
  scene.add_particle(1.0, {1, 0, 0});
  scene.add_spring(0, 1, 50.0, 1.0);
  scene.pin(0, {{0.0, {0, 0, 0}}, {1.0, {-1, 0, 0}}});
  Simulation<double> simulation(scene, {.step = 1e-3});
  REQUIRE(simulation.step(1000).ok());
  CHECK(position(simulation, 0).x() == doctest::Approx(-1.0));
  CHECK(position(simulation, 1).x() < 0.2);
}
