// What wakes sleepers: the host, what moves near or touches them, time.

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <hooke/hooke.h>

#include "effects/sleep_scenes.h"
#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

TEST_CASE("the host wakes what it pushes, moves and names, and nothing else") {
  const Resting resting;
  Simulation<float> simulation = asleep_after<float>(resting.scene, 2 * of_cloth);
  const auto sleeps = [&](Index particle) { return simulation.is_asleep(particle); };
  SUBCASE("by an impulse") {
    CHECK_THROWS_AS(simulation.apply_impulse(resting.first, Vec3::Constant(1e300)), std::invalid_argument);
    CHECK(sleeps(resting.first));
    simulation.apply_impulse(resting.first + 9, {0.0, 0.01, 0.0});
    CHECK(!sleeps(resting.first));
    simulation.step();
    CHECK(velocity(simulation, resting.first + 9).y() > 0.0);
  }
  SUBCASE("by a teleport") {
    std::vector<Index> cloth(of_cloth);
    std::iota(cloth.begin(), cloth.end(), resting.first);
    simulation.teleport(cloth, {{0.0, 0.01, 0.0}});
    CHECK(!sleeps(resting.first));
  }
  SUBCASE("by name") {
    simulation.wake(resting.first);
    CHECK(!sleeps(resting.first));
  }
  CHECK(sleeps(resting.second));
  simulation.step(300);
  CHECK(sleeps(resting.first));
}

TEST_CASE("a solid wakes what it comes near, when it moves") {
  Resting resting;
  const std::size_t ball = resting.scene.effects.size();
  resting.scene.effects.push_back(Collider{.shape = SphereShape{{0.07, 0.5, 0.07}, 0.05}});
  Simulation<float> simulation = asleep_after<float>(resting.scene, 2 * of_cloth);
  double height = 0.5;
  while (simulation.is_asleep(resting.first)) {
    height -= 0.01;
    REQUIRE(height > 0.0);
    simulation.move_frame(ball, {{0.0, height - 0.5, 0.0}});
    simulation.step();
  }
  CHECK(height > 0.03);
  CHECK(height < 0.08);
  CHECK(simulation.is_asleep(resting.second));
  for (; height > 0.03; height -= 0.01) {
    simulation.move_frame(ball, {{0.0, height - 0.5, 0.0}});
    simulation.step();
  }
  // It stands still again, and the cloth that it presses on may sleep.
  simulation.step(400);
  CHECK(simulation.is_asleep(resting.first));
}

TEST_CASE("what falls on a sleeper wakes it when it touches, and both sleep together and wake together") {
  Scene scene = floor_with();
  std::get<Sleep>(scene.effects[2]).speed = 5e-3;
  const Index below = lay_cloth(scene, {0.0, 1e-3, 0.0}), above = lay_cloth(scene, {0.0, 0.3, 0.003});
  const Index aside = lay_cloth(scene, {1.0, 1e-3, 0.0});
  scene.effects.push_back(SelfCollision{.thickness = thickness, .friction = 0.3});
  Simulation<double> simulation(scene, {.step = 5e-3, .threads = 1});
  const auto height = [&](Index first) {
    double lowest = 1.0;
    for (Index i = 0; i < of_cloth; ++i) lowest = std::min(lowest, position(simulation, first + i).y());
    return lowest;
  };
  while (!simulation.is_asleep(below)) {
    simulation.step();
    REQUIRE(simulation.time() < 0.24);
  }
  while (simulation.is_asleep(below)) {
    REQUIRE(height(above) > 1e-3);
    simulation.step();
  }
  CHECK(height(above) < 1e-3 + 1.25 * thickness);
  CHECK(simulation.is_asleep(aside));
  while (asleep(simulation.step()) < 3 * of_cloth) {
    REQUIRE(simulation.is_asleep(below) == simulation.is_asleep(above));
    REQUIRE(simulation.time() < 10.0);
  }
  simulation.wake(below);
  CHECK(!simulation.is_asleep(above));
  CHECK(simulation.is_asleep(aside));
  CHECK(height(above) - height(below) > 0.5 * thickness);
}

TEST_CASE("grains wake each other") {
  Scene scene = floor_with();
  const double radius = 0.01;
  for (int i = 0; i < 4; ++i) scene.add_particle(0.01, {2.0 * radius * i, 0.0, 0.0});
  scene.add_particle(0.01, {0.0, 0.4, 0.0});
  std::get<Collider>(scene.effects[1]).thickness = 0.0;
  scene.effects.push_back(ParticleContact{.radius = {radius}, .stiffness = 100.0, .damping = 0.1});
  for (const Method& method :
       {Method{SymplecticEuler{}}, Method{BackwardEuler{}}, Method{VertexBlockDescent{}}}) {
    CAPTURE(to_string(method));
    Simulation<double> simulation(scene, {.method = method, .step = 1e-3, .threads = 1});
    REQUIRE(asleep(simulation.step(260)) == 4);
    while (simulation.is_asleep(0)) {
      simulation.step();
      REQUIRE(simulation.time() < 0.5);
    }
    const double gap = (position(simulation, 4) - position(simulation, 0)).norm();
    CHECK(gap < 2.0 * radius);
    CHECK(gap > 1.5 * radius);
  }
}

TEST_CASE("what changes with time keeps awake whom it works on, and wakes them") {
  Resting resting;
  SUBCASE("a force script") {
    resting.scene.effects.push_back(ForceScript{
        {resting.first + 9}, {{0.5, {0.0, 0.0, 0.0}}, {0.7, {0.0, 1e-4, 0.0}}, {5.0, {0.0, 1e-4, 0.0}}}});
    Simulation<float> simulation = asleep_after<float>(resting.scene, 2 * of_cloth);
    REQUIRE(simulation.time() < 0.45);
    while (simulation.time() < 0.52) simulation.step();
    CHECK(!simulation.is_asleep(resting.first));
    CHECK(simulation.is_asleep(resting.second));
    simulation.step(200);
    CHECK(simulation.is_asleep(resting.first));
  }
  SUBCASE("a path of a pin") {
    resting.scene.pin(resting.first, {{0.5, Vec3::Zero()}, {1.0, {0.0, 0.05, 0.0}}});
    Simulation<float> simulation = asleep_after<float>(resting.scene, 2 * of_cloth);
    while (simulation.time() < 0.6) simulation.step();
    CHECK(!simulation.is_asleep(resting.first));
    CHECK(simulation.is_asleep(resting.second));
    CHECK(position(simulation, resting.first).y() > 5e-3);
  }
  SUBCASE("forces and moves that begin and end within a step") {
    const double at = 0.5012;  // steps end each 5 ms
    const std::vector<ForceKeyframe> even{{at, {0.0, 1e-3, 0.0}}, {at + 0.003, {0.0, 1e-3, 0.0}}};
    const std::vector<Keyframe> there_and_back{{at}, {at + 0.001, {0.0, 1e-4, 0.0}}, {at + 0.003}};
    SUBCASE("a force") {
      resting.scene.effects.push_back(ForceScript{{resting.first + 9}, even});
    }
    SUBCASE("a pin") {
      resting.scene.pin(resting.first, there_and_back);
    }
    Simulation<float> simulation = asleep_after<float>(resting.scene, 2 * of_cloth);
    while (simulation.time() < 0.503) {
      CHECK(simulation.is_asleep(resting.first));
      simulation.step();
    }
    CHECK(!simulation.is_asleep(resting.first));
    CHECK(simulation.is_asleep(resting.second));
  }
  SUBCASE("a path of a pin that rests on its way") {
    resting.scene.pin(resting.first, {{0.0}, {0.1, {0.0, 0.0013, 0.0}}, {9.0, {0.0, 0.0013, 0.0}}});
    Simulation<float> simulation = asleep_after<float>(resting.scene, 2 * of_cloth);
    for (int i = 0; i < 200; ++i) CHECK(asleep(simulation.step()) == 2 * of_cloth);
  }
  SUBCASE("a path of a solid that rests on its way") {
    Collider& floor = std::get<Collider>(resting.scene.effects[1]);
    floor.path = {{0.0}, {0.1, Vec3::Zero(), 13.7}, {9.0, Vec3::Zero(), 13.7}};
    Simulation<float> simulation = asleep_after<float>(resting.scene, 2 * of_cloth);
    for (int i = 0; i < 200; ++i) CHECK(asleep(simulation.step()) == 2 * of_cloth);
  }
  SUBCASE("wind that sets in") {
    resting.scene.effects.push_back(ParticleWind{1e-4, UniformField{{0.1, 0.0, 0.0}},
                                                 RampEnvelope{.start = 0.5, .end = 0.6, .from = 0.0}});
    Simulation<float> simulation = asleep_after<float>(resting.scene, 2 * of_cloth);
    while (simulation.time() < 0.52) simulation.step();
    CHECK(asleep(simulation.step(0)) == 0);
    simulation.step(200);
    CHECK(asleep(simulation.step(0)) == 2 * of_cloth);
  }
}
