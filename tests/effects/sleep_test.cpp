#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include <hooke/hooke.h>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr Index side = 8;
constexpr double spacing = 0.02, thickness = 2e-3;

/// Of fixed steps, as colliders need them, and such that bear oscillations without damping.
std::vector<Method> methods_of_cloth_on_the_floor() {
  std::vector<Method> methods;
  for (const Method& method : all_methods) {
    const bool grows = std::visit([](const auto& one) { return one.oscillation_limit == 0.0; }, method);
    if (!grows && !std::holds_alternative<DormandPrince>(method)) methods.push_back(method);
  }
  return methods;
}

/// A cloth that lies flat at a height; its particles begin at the one returned.
Index lay_cloth(Scene& scene, const Vec3& place) {
  ClothGrid cloth{.columns = side, .rows = side, .spacing = spacing, .areal_density = 0.5, .stretch = 50.0};
  cloth.shear = 25.0, cloth.bend = 0.5, cloth.damping = 0.01;
  cloth.placement = {.translation = place, .rotation_axis = {1.0, 0.0, 0.0}, .rotation_degrees = -90.0};
  return add(scene, cloth).first;
}

/// A pendulum of which nothing slows but the stretch.
Index hang_pendulum(Scene& scene, const Vec3& place) {
  const Index pin = scene.add_particle(0.1, place);
  const Index bob = scene.add_particle(0.1, place + Vec3(0.3, 0.0, 0.0));
  scene.add_spring(pin, bob, 500.0, 0.3, 0.5);
  scene.pin(pin);
  return bob;
}

Scene floor_with(double time = 0.2) {
  Scene scene;
  scene.effects = {Gravity{}, Collider{.shape = PlaneShape{}, .thickness = 1e-3, .friction = 0.5},
                   Sleep{.speed = 2e-3, .time = time}};
  return scene;
}

/// Two cloths on the floor, and a pendulum.
struct Resting {
  Scene scene = floor_with();
  Index first, second, bob;

  Resting() {
    first = lay_cloth(scene, {0.0, 1e-3, 0.0});
    second = lay_cloth(scene, {0.5, 1e-3, 0.0});
    bob = hang_pendulum(scene, {0.0, 1.0, 1.0});
  }
};

std::size_t asleep(const Report& report) {
  return std::size_t(report.particles_asleep);
}

constexpr std::size_t of_cloth = side * side;

template <class Real>
Simulation<Real> asleep_after(const Scene& scene, const Method& method, std::size_t particles,
                              int most = 200) {
  Simulation<Real> simulation(scene, {.method = method, .step = 5e-3, .threads = 1});
  for (int i = 0; i < most; ++i) {
    if (asleep(simulation.step()) == particles) return simulation;
  }
  FAIL("not asleep after " << most << " steps");
  return simulation;
}

template <class Real>
Simulation<Real> asleep_after(const Scene& scene, std::size_t particles) {
  return asleep_after<Real>(scene, SymplecticEuler{}, particles);
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
