#include <doctest/doctest.h>

#include <cmath>

#include <hooke/scene.h>

using namespace hooke;

TEST_CASE("particles and springs are numbered in the order they are added") {
  Scene scene;
  CHECK(scene.add_particle(1.0, {0, 0, 0}) == 0);
  CHECK(scene.add_particle(2.0, {1, 2, 3}) == 1);
  CHECK(scene.add_spring(1, 0, 5.0, 0.25) == 0);
  CHECK(scene.add_spring(0, 1, 6.0, 0.5) == 1);
  CHECK(scene.particles.mass == std::vector<double>{1.0, 2.0});
  CHECK(scene.particles.position[1] == Vec3(1, 2, 3));
  CHECK(scene.springs.first == std::vector<Index>{1, 0});
  CHECK(scene.springs.second == std::vector<Index>{0, 1});
  CHECK(scene.springs.stiffness == std::vector<double>{5.0, 6.0});
  CHECK(scene.springs.rest_length == std::vector<double>{0.25, 0.5});
}

TEST_CASE("velocities are stored from the first that is not zero") {
  Scene scene;
  scene.add_particle(1.0, {0, 0, 0});
  scene.add_particle(1.0, {1, 0, 0});
  CHECK(scene.particles.velocity.empty());
  scene.add_particle(1.0, {2, 0, 0}, {0, 0, -3});
  scene.add_particle(1.0, {3, 0, 0});
  CHECK(scene.particles.velocity == std::vector<Vec3>{Vec3::Zero(), Vec3::Zero(), {0, 0, -3}, Vec3::Zero()});
}

TEST_CASE("damping is stored from the first that is not zero") {
  Scene scene;
  scene.add_spring(0, 1, 1.0, 1.0);
  CHECK(scene.springs.damping.empty());
  scene.add_spring(0, 1, 1.0, 1.0, 0.5);
  scene.add_spring(0, 1, 1.0, 1.0);
  CHECK(scene.springs.damping == std::vector<double>{0.0, 0.5, 0.0});
}

TEST_CASE("a first element can move or be damped") {
  Scene scene;
  scene.add_particle(1.0, {0, 0, 0}, {1, 0, 0});
  scene.add_spring(0, 0, 1.0, 1.0, 2.0);
  CHECK(scene.particles.velocity.size() == 1);
  CHECK(scene.springs.damping.size() == 1);
}

TEST_CASE("values that are not numbers are stored, so that validate() sees them") {
  Scene scene;
  scene.add_particle(1.0, {0, 0, 0}, {NAN, 0, 0});
  scene.add_spring(0, 0, 1.0, 1.0, NAN);
  CHECK(scene.particles.velocity.size() == 1);
  CHECK(scene.springs.damping.size() == 1);
}

TEST_CASE("pins keep their path") {
  Scene scene;
  scene.pin(4);
  scene.pin(7, {{0.5, {1, 0, 0}}});
  REQUIRE(scene.pins.size() == 2);
  CHECK(scene.pins[0].particle == 4);
  CHECK(scene.pins[0].path.empty());
  CHECK(scene.pins[1].particle == 7);
  REQUIRE(scene.pins[1].path.size() == 1);
  CHECK(scene.pins[1].path[0].displacement == Vec3(1, 0, 0));
}
