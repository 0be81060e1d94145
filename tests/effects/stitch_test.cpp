#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <hooke/hooke.h>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double g = 9.81;

/// Two halves of a rope, one below the other, sewn together at their ends: particles 4 and 5 are in one
/// place, and all springs as long as they are at rest under the weight below.
Scene sewn_rope() {
  constexpr double m = 0.02, k = 500.0;
  Scene scene;
  double y = 0.0;
  for (Index i = 0; i < 10; ++i) {
    const double below = double(10 - i) * m * g;
    if (i > 0 && i != 5) y -= 0.1 + below / k;
    scene.add_particle(m, {0, y, 0});
    if (i > 0 && i != 5) scene.add_spring(i - 1, i, k, 0.1, 0.1);
  }
  scene.pin(0);
  scene.effects = {Gravity{{0.0, -g, 0.0}}, Stitch{.first = {4}, .second = {5}}};
  return scene;
}

/// Particles without forces, from a small seed.
Scene cloud(Index particles) {
  Scene scene;
  std::mt19937 random(4);
  const auto unit = [&] { return double(random()) / 2147483648.0 - 1.0; };
  for (Index i = 0; i < particles; ++i) {
    const Vec3 x(unit(), unit(), unit()), v(unit(), unit(), unit());
    scene.add_particle(1.5 + unit(), x, v);
  }
  return scene;
}

double distance(const Simulation<double>& simulation, Index a, Index b) {
  return (position(simulation, a) - position(simulation, b)).norm();
}

}  // namespace

TEST_CASE("a stitch under tension carries the weight below it") {
  for (const Method& method : {Method(SymplecticEuler{}), Method(RungeKutta4{}), Method(Verlet{})}) {
    CAPTURE(to_string(method));
    Simulation<double> simulation(sewn_rope(), {.method = method, .step = 1e-3});
    REQUIRE(simulation.step(2000).ok());
    REQUIRE(simulation.step(1).ok());
    const std::vector<Vec3> forces = simulation.stitch_forces(1);
    REQUIRE(forces.size() == 1);
    CHECK(forces[0].y() == doctest::Approx(-5 * 0.02 * g).epsilon(1e-3));  // the upper end is pulled down
    CHECK(std::hypot(forces[0].x(), forces[0].z()) < 1e-12);
    CHECK(distance(simulation, 4, 5) == 0.0);
    CHECK(distance(simulation, 0, 9) ==
          doctest::Approx(sewn_rope().particles.position[9].norm()).epsilon(1e-4));
  }
}

TEST_CASE("a closed knot moves with its centre of mass: momentum is kept, and no energy added") {
  Scene scene = cloud(8);
  for (Vec3& x : scene.particles.position) x = {0.5, 0.0, 0.0};
  // A chain of pairs, a ring and a pair apart.
  scene.effects = {Stitch{.first = {0, 1, 2, 0, 6}, .second = {1, 2, 3, 2, 7}}};
  Simulation<double> simulation(scene, {.step = 1e-2});
  const Vec3 momentum = simulation.momentum();
  const double energy = simulation.energy().kinetic;
  REQUIRE(simulation.step(1).ok());
  CHECK((simulation.momentum() - momentum).norm() < 1e-14);
  CHECK(simulation.energy().kinetic < energy);
  for (const Index i : {1u, 2u, 3u}) CHECK(distance(simulation, 0, i) == 0.0);
  CHECK(distance(simulation, 6, 7) == 0.0);
  CHECK(distance(simulation, 0, 6) > 0.0);
  // What pairs carry is what their particles got; the one that closes the ring carries nothing.
  const std::vector<Vec3> forces = simulation.stitch_forces(0);
  const auto got = [&](Index i) -> Vec3 {
    return scene.particles.mass[i] * (velocity(simulation, i) - scene.particles.velocity[i]) / 1e-2;
  };
  CHECK((forces[4] - got(6)).norm() < 1e-12);
  CHECK((-forces[4] - got(7)).norm() < 1e-12);
  CHECK((-forces[2] - got(3)).norm() < 1e-12);
  CHECK((forces[0] + forces[3] - got(0)).norm() < 1e-12);
  CHECK((forces[1] - forces[0] - got(1)).norm() < 1e-12);
  CHECK((forces[2] - forces[1] - forces[3] - got(2)).norm() < 1e-12);
  const double after = simulation.energy().kinetic;
  REQUIRE(simulation.step(100).ok());
  CHECK(simulation.energy().kinetic == doctest::Approx(after).epsilon(1e-12));
}

TEST_CASE("a seam that is open closes evenly over its time, and keeps momentum") {
  Scene scene = cloud(6);
  for (Vec3& v : scene.particles.velocity) v = {0.1, 0.0, 0.0};
  scene.effects = {Stitch{.first = {0, 2, 3}, .second = {1, 3, 4}, .closing_time = 0.5}};
  Simulation<double> simulation(scene, {.step = 1e-2});
  const Vec3 momentum = simulation.momentum();
  const auto start = [&](Index a, Index b) {
    return (scene.particles.position[a] - scene.particles.position[b]).norm();
  };
  for (int i = 1; i <= 60; ++i) {
    REQUIRE(simulation.step(1).ok());
    const double open = std::max(0.0, 1.0 - simulation.time() / 0.5);
    CHECK(distance(simulation, 0, 1) <= open * start(0, 1) * (1.0 + 1e-9) + 1e-12);
    CHECK(distance(simulation, 0, 1) >= open * start(0, 1) * (1.0 - 1e-9) - 1e-12);
    for (const auto& [a, b] : {std::pair{2u, 3u}, std::pair{3u, 4u}})
      CHECK(distance(simulation, a, b) <= open * start(a, b) * (1.0 + 1e-9) + 1e-12);
    CHECK((simulation.momentum() - momentum).norm() < 1e-12);
  }
  // What went together stays together, with the velocity that it had as a whole.
  CHECK(distance(simulation, 2, 4) == 0.0);
  CHECK((velocity(simulation, 0) - Vec3(0.1, 0, 0)).norm() < 1e-12);
}

TEST_CASE("pairs that are together in a knot that closes do not close it at once") {
  Scene scene = cloud(4);
  scene.particles.position[1] = scene.particles.position[0];
  scene.effects = {Gravity{}, Stitch{.first = {0, 1}, .second = {1, 2}, .closing_time = 1.0}};
  Simulation<double> simulation(scene, {.step = 1e-2});
  const double start = (scene.particles.position[1] - scene.particles.position[2]).norm();
  REQUIRE(simulation.step(50).ok());
  CHECK(distance(simulation, 0, 1) < 1e-12);
  CHECK(distance(simulation, 1, 2) <= 0.5 * start * (1.0 + 1e-9));
  CHECK(distance(simulation, 1, 2) > 0.3 * start);
  REQUIRE(simulation.step(50).ok());
  CHECK(distance(simulation, 0, 2) == 0.0);
}

TEST_CASE("a seam that is late is drawn in without a gain of energy") {
  Scene scene = cloud(4);
  scene.effects = {Stitch{.first = {0}, .second = {1}, .closing_time = 10.0}};
  Simulation<double> simulation(scene, {.step = 1e-2});
  REQUIRE(simulation.step(5).ok());
  Snapshot<double> snapshot = simulation.snapshot();
  snapshot.positions[0] += 100.0;  // torn apart from outside
  simulation.restore(snapshot);
  const double energy = simulation.energy().kinetic;
  REQUIRE(simulation.step(1).ok());
  CHECK(simulation.energy().kinetic <= energy);
  CHECK(distance(simulation, 0, 1) < 3.5);
}

TEST_CASE("what is pinned, attached or scripted stays, and its seam comes to it") {
  Scene scene = cloud(8);
  scene.particles.velocity.clear();
  scene.pin(0);
  scene.effects = {FrameAttachment{.particles = {2}, .path = {{0.0}, {1.0, {0, 1, 0}}}},
                   MotionScript{{4}, {{0.0, Vec3::Zero()}, {1.0, {0, 0, 1}}}},
                   Stitch{.first = {0, 3, 4, 5}, .second = {1, 2, 5, 6}, .closing_time = 0.2}};
  Simulation<double> simulation(scene, {.step = 1e-2});
  REQUIRE(simulation.step(50).ok());
  CHECK(position(simulation, 1) == scene.particles.position[0]);
  CHECK(position(simulation, 3) == position(simulation, 2));
  CHECK((position(simulation, 2) - scene.particles.position[2] - Vec3(0, 0.5, 0)).norm() < 1e-12);
  CHECK((velocity(simulation, 3) - Vec3(0, 1, 0)).norm() < 1e-9);
  for (const Index i : {5u, 6u}) CHECK(position(simulation, i) == position(simulation, 4));
  CHECK((position(simulation, 4) - scene.particles.position[4] - Vec3(0, 0, 0.5)).norm() < 1e-12);
}

TEST_CASE_TEMPLATE("a sewn cloth goes on with the same bits from a snapshot", Real, float, double) {
  Scene scene = hung_cloth(12, 10, 0.001);
  const std::size_t half = scene.particles.size();
  add(scene, ClothGrid{.columns = 12,
                       .rows = 4,
                       .spacing = 0.02,
                       .areal_density = 2.0,
                       .stretch = 100.0,
                       .placement = {.translation = {0.0, -0.25, 0.02}}});
  Stitch seam{.closing_time = 0.1};
  for (Index i = 0; i < 12; ++i) {
    seam.first.push_back(Index(half) - 12 + i);
    seam.second.push_back(Index(half) + i);
  }
  scene.effects.push_back(seam);
  Simulation<Real> whole(scene, {.step = 1e-3}), other(scene, {.step = 1e-3});
  REQUIRE(whole.step(60).ok());
  const Snapshot<Real> middle = whole.snapshot();
  REQUIRE(whole.step(100).ok());
  other.restore(middle);
  REQUIRE(other.step(100).ok());
  CHECK(other.state_hash() == whole.state_hash());
  for (Index i = 0; i < 12; ++i) CHECK(position(whole, seam.first[i]) == position(whole, seam.second[i]));
}

TEST_CASE("each fault of a stitch is named") {
  Scene scene = cloud(6);
  scene.pin(0);
  scene.pin(3);
  scene.effects = {Stitch{},
                   Stitch{.first = {0, 1}, .second = {1}},
                   Stitch{.first = {2, 9}, .second = {2, 1}},
                   Stitch{.first = {0, 1}, .second = {1, 3}, .closing_time = -1.0},
                   Stitch{.first = {4}, .second = {5}, .closing_time = NAN},
                   Stitch{.first = {4}, .second = {5}},
                   Stitch{.first = {4}, .second = {4}, .closing_time = 1.0}};
  std::string all;
  for (const Fault& fault : validate(scene)) all += fault.message() + "\n";
  CAPTURE(all);
  for (const char* expected :
       {"effects[0] (stitch): the number of pairs is 0",
        "effects[1] (stitch): first has 2 particles and second 1", "first[1] is 9", "closing_time is -1 s",
        "closing_time is nan", "effects[3] (stitch): sews particle 3 to particle 0, and both are pinned",
        "effects[5] (stitch): pair 0 is ", "m apart at the start",
        "effects[6] (stitch): pair 0 sews particle 4 to itself"})
    CHECK(all.find(expected) != all.npos);
}
