// What falls asleep, what stays awake, and what sleep leaves as it is.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <hooke/hooke.h>

#include "effects/sleep_scenes.h"
#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// Of fixed steps, as colliders need them, and such that bear oscillations without damping.
std::vector<Method> methods_of_cloth_on_the_floor() {
  std::vector<Method> methods;
  for (const Method& method : all_methods) {
    const bool grows = std::visit([](const auto& one) { return one.oscillation_limit == 0.0; }, method);
    if (!grows && !std::holds_alternative<DormandPrince>(method)) methods.push_back(method);
  }
  return methods;
}

}  // namespace

TEST_CASE_TEMPLATE("what has come to rest sleeps where it is, and the rest goes on, by every method", Real,
                   float, double) {
  const Resting resting;
  for (const Method& method : methods_of_cloth_on_the_floor()) {
    CAPTURE(to_string(method));
    Simulation<Real> simulation(resting.scene, {.method = method, .step = 5e-3, .threads = 1});
    Report report;
    for (int i = 0; i < 200 && asleep(report) < 2 * of_cloth; ++i) {
      report = simulation.step();
      REQUIRE(report.ok());
    }
    REQUIRE(asleep(report) == 2 * of_cloth);
    CHECK(simulation.is_asleep(resting.first));
    CHECK(!simulation.is_asleep(resting.bob));
    const Vec3 place = position(simulation, resting.first), bob = position(simulation, resting.bob);
    simulation.step(20);
    CHECK(position(simulation, resting.first) == place);
    CHECK(velocity(simulation, resting.first).isZero());
    CHECK((position(simulation, resting.bob) - bob).norm() > 1e-3);
  }
}

TEST_CASE("falling asleep and waking change the energy by less than a millionth") {
  Scene scene = floor_with();
  std::get<Sleep>(scene.effects[2]).speed = 1e-3;
  const Index first = lay_cloth(scene, {0.0, 0.2, 0.0});
  for (const Method& method : {Method{SymplecticEuler{}}, Method{RungeKutta4{}}, Method{BackwardEuler{}}}) {
    CAPTURE(to_string(method));
    Simulation<double> simulation(scene, {.method = method, .step = 5e-3, .threads = 1});
    const double scale = simulation.energy().total();
    double before = 0.0;
    int steps = 0;
    do {
      before = simulation.energy().total();
      REQUIRE(++steps < 600);
    } while (asleep(simulation.step()) == 0);
    CHECK(std::abs(simulation.energy().total() - before) < 1e-6 * scale);
    const double asleep_energy = simulation.energy().total();
    CHECK(simulation.energy().kinetic == 0.0);
    simulation.step(50);
    CHECK(simulation.energy().total() == asleep_energy);
    simulation.wake(first);
    CHECK(!simulation.is_asleep(first));
    CHECK(simulation.energy().total() == asleep_energy);
    REQUIRE(simulation.step(10).ok());
    CHECK(std::abs(simulation.energy().total() - asleep_energy) < 1e-6 * scale);
  }
}

TEST_CASE("what stays awake has the same bits whether something else sleeps or not") {
  Resting resting;
  Simulation<float> sleeping(resting.scene, {.step = 5e-3, .threads = 1});
  resting.scene.effects.pop_back();
  Simulation<float> awake(resting.scene, {.step = 5e-3, .threads = 1});
  for (int i = 0; i < 100; ++i) {
    sleeping.step(), awake.step();
    REQUIRE(position(sleeping, resting.bob) == position(awake, resting.bob));
    REQUIRE(velocity(sleeping, resting.bob) == velocity(awake, resting.bob));
  }
  CHECK(sleeping.is_asleep(resting.first));
}

TEST_CASE_TEMPLATE("sleepers have the same bits on any number of threads, and after a snapshot of them", Real,
                   float, double) {
  Resting resting;
  resting.scene.effects.push_back(SelfCollision{.thickness = thickness});
  lay_cloth(resting.scene, {0.5, 0.4, 0.0});  // falls on the second one
  for (const Method& method : {Method{Verlet{}}, Method{Bdf2{}}, Method{VertexBlockDescent{}}}) {
    CAPTURE(to_string(method));
    Simulation<Real> one(resting.scene, {.method = method, .step = 5e-3, .threads = 1});
    Simulation<Real> three(resting.scene, {.method = method, .step = 5e-3, .threads = 3});
    for (int part = 0; part < 4; ++part) {
      const Report report = one.step(20);
      three.step(20);
      REQUIRE(one.state_hash() == three.state_hash());
      Simulation<Real> restored(resting.scene, {.method = method, .step = 5e-3, .threads = 1});
      restored.restore(one.snapshot());
      CHECK(restored.state_hash() == one.state_hash());
      CHECK(restored.step(0).particles_asleep == report.particles_asleep);
      Simulation<Real> original(resting.scene, {.method = method, .step = 5e-3, .threads = 1});
      original.restore(one.snapshot());
      original.step(10), restored.step(4), restored.step(6);
      CHECK(restored.state_hash() == original.state_hash());
    }
  }
}

TEST_CASE("what the host is told the load of, and what calls the host, stays awake") {
  Resting resting;
  SUBCASE("attached to a frame") {
    resting.scene.effects.push_back(FrameAttachment{.particles = {resting.first}});
    Simulation<float> simulation(resting.scene, {.step = 5e-3, .threads = 1});
    CHECK(asleep(simulation.step(200)) == of_cloth);
    CHECK(simulation.is_asleep(resting.second));
  }
  SUBCASE("a custom effect") {
    resting.scene.effects.push_back(CustomEffect{"nothing", [](const ParticleBatch&) {}});
    Simulation<float> simulation(resting.scene, {.step = 5e-3, .threads = 1});
    CHECK(asleep(simulation.step(200)) == 0);
  }
}

TEST_CASE("a pendulum at the end of its swing does not sleep, and a seam joins islands") {
  Scene scene = floor_with(0.1);
  hang_pendulum(scene, {0.0, 1.0, 1.0});
  const Index a = scene.add_particle(0.1, {0.3, 0.0, 0.0}), b = scene.add_particle(0.1, {0.3, 0.0, 0.0});
  scene.effects.push_back(Stitch{.first = {a}, .second = {b}});
  std::get<Collider>(scene.effects[1]).thickness = 0.0;
  Simulation<double> simulation(scene, {.step = 5e-3, .threads = 1});
  for (int i = 0; i < 600; ++i) REQUIRE(asleep(simulation.step()) <= 2);
  REQUIRE(simulation.is_asleep(a));
  simulation.apply_impulse(a, {0.0, 0.1, 0.0});
  CHECK(!simulation.is_asleep(b));
}

TEST_CASE("what sleeps does not creep, whatever else is awake") {
  Scene scene;
  const Index links = 8;
  Plasticity plasticity{.yield = 0.0, .rate = 0.01};
  for (Index i = 0; i <= links; ++i) {
    scene.add_particle(0.01, {0.0, -0.052 * i, 0.0});
    if (i > 0)
      plasticity.springs.push_back(Index(scene.springs.size())), scene.add_spring(i - 1, i, 60.0, 0.05, 0.5);
  }
  scene.pin(0);
  const Index bob = hang_pendulum(scene, {1.0, 0.0, 0.0});
  scene.effects = {Gravity{}, Drag{0.1}, plasticity, Sleep{.speed = 2e-2, .time = 0.1}};
  Simulation<double> simulation = asleep_after<double>(scene, links + 1);
  const std::vector<double> before = simulation.snapshot().effects;
  CHECK(*std::ranges::max_element(before) > 0.0);
  for (int i = 0; i < 20; ++i) REQUIRE(asleep(simulation.step()) == links + 1);
  CHECK(!simulation.is_asleep(bob));
  CHECK(simulation.snapshot().effects == before);
}

TEST_CASE("sleep that cannot be is refused, and so are particles that are not there") {
  const auto fault_of = [](const std::vector<Effect>& effects) {
    Scene scene = one_particle();
    scene.effects = effects;
    const std::vector<Fault> faults = validate(scene);
    REQUIRE(faults.size() == 1);
    return faults[0].message();
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(fault_of({Sleep{.speed = 0.0}}).find("speed") != std::string::npos);
  CHECK(fault_of({Sleep{.speed = nan}}).find("speed") != std::string::npos);
  CHECK(fault_of({Sleep{.time = -1.0}}).find("time") != std::string::npos);
  CHECK(fault_of({Sleep{.time = nan}}).find("time") != std::string::npos);
  CHECK_THROWS_AS(Simulation<float>(one_particle()).wake(1), std::out_of_range);
  CHECK_THROWS_AS(Simulation<float>(one_particle()).is_asleep(1), std::out_of_range);
  Simulation<float> awake(one_particle());
  CHECK(!awake.is_asleep(0));
  Snapshot<float> snapshot = awake.snapshot();
  snapshot.resting = {1, 2};
  CHECK_THROWS_AS(awake.restore(snapshot), std::invalid_argument);
}
