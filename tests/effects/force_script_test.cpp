#include <doctest/doctest.h>

#include <string>

#include <hooke/hooke.h>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

TEST_CASE("a force script acts on its particles alone, along straight lines, and only while it lasts") {
  Scene scene;
  for (int i = 0; i < 300; ++i) scene.add_particle(2.0, {0.1 * i, 0, 0});
  scene.effects = {ForceScript{{299, 7, 130}, {{1.0, {0, 0, 0}}, {2.0, {4, 8, -2}}, {4.0, {0, 0, 0}}}}};
  Simulation<double> simulation(scene, {.method = RungeKutta4{}, .step = 0.125});
  REQUIRE(simulation.step(8).ok());
  CHECK(velocity(simulation, 7).isZero());
  REQUIRE(simulation.step(8).ok());
  CHECK(velocity(simulation, 7).isApprox(0.5 * Vec3(4, 8, -2) / 2.0));  // its integral over the mass
  REQUIRE(simulation.step(24).ok());
  for (Index i = 0; i < 300; ++i) {
    const bool named = i == 7 || i == 130 || i == 299;
    REQUIRE((velocity(simulation, i) - (named ? Vec3(3, 6, -1.5) : Vec3(0, 0, 0))).norm() < 1e-12);
  }
}

TEST_CASE("a constant force of a script gives its impulse and no more") {
  Scene scene;
  scene.add_particle(2.0, {0, 0, 0});
  scene.effects = {ForceScript{{0}, {{0.5, {4, 0, 8}}, {1.5, {4, 0, 8}}}}};
  Simulation<double> simulation(scene, {.step = 0.125});
  REQUIRE(simulation.step(4).ok());
  CHECK(velocity(simulation, 0).isZero());
  REQUIRE(simulation.step(20).ok());
  CHECK(velocity(simulation, 0).isApprox(Vec3(2, 0, 4)));
}

TEST_CASE("a force script reaches its particles also where the engine has another order") {
  Scene scene = RandomNetwork(5).make();
  const Index chosen = 7;
  scene.pins.clear();
  scene.springs = {};
  scene.effects = {ForceScript{{chosen}, {{0.0, {1, 2, 3}}, {1.0, {1, 2, 3}}}}};
  Simulation<double> simulation(scene, {.step = 0.25});
  REQUIRE(simulation.step(2).ok());
  const Vec3 kick = velocity(simulation, chosen) - scene.particles.velocity[chosen];
  CHECK(kick.isApprox(0.5 / scene.particles.mass[chosen] * Vec3(1, 2, 3)));
}

TEST_CASE("each fault of a force script is named") {
  Scene scene;
  scene.add_particle(1.0, {0, 0, 0});
  scene.effects = {ForceScript{{0, 3, 0}, {{1.0, {0, 0, 0}}, {0.5, {NAN, 0, 0}}}}};
  std::string all;
  for (const Fault& fault : validate(scene)) all += fault.message() + "\n";
  CAPTURE(all);
  for (const char* expected :
       {"particles[1] is 3, but the number of particles is 1", "particles[2] is 0, which is named before",
        "keyframes[1].time is 0.5 s, but an earlier keyframe has 1 s",
        "keyframes[1].force is (nan, 0, 0) N; give finite values"})
    CHECK(all.find(expected) != all.npos);
}
