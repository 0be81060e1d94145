#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <hooke/hooke.h>

#include "effects/crossings.h"
#include "fine_executor.h"
#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double radius = 0.1, thickness = 0.003;
const Settings frames{.step = 1.0 / 60.0, .threads = 1};

Collider ball(const Vec3& centre, std::vector<RigidKeyframe> path = {}) {
  return {
      .shape = SphereShape{centre, radius}, .thickness = thickness, .friction = 0.3, .path = std::move(path)};
}

/// Two balls whose surfaces overlap by 2 cm where they meet.
std::vector<Collider> overlapping_balls() {
  return {ball({0.0, 0.0, -0.09}), ball({0.0, 0.0, 0.09})};
}

/// A cloth hung between two balls that come together until they overlap by 2 cm, wait, and go apart.
Scene squeezed_cloth() {
  Scene scene = hung_cloth(16, 16, 0.02);
  Vec3 centre = Vec3::Zero();
  for (const Vec3& x : scene.particles.position) centre += x / 256.0;
  for (Vec3& x : scene.particles.position) x -= centre + Vec3(0.007, 0.004, 0.0);
  for (const double side : {-1.0, 1.0}) {
    const Vec3 in(0.0, 0.0, -0.06 * side);
    scene.effects.push_back(
        ball({0.0, 0.0, 0.15 * side},
             {{0.0, Vec3::Zero(), 0.0}, {0.3, in, 0.0}, {0.6, in, 0.0}, {0.9, Vec3::Zero(), 0.0}}));
  }
  return scene;
}

double distance_to_balls(const Vec3& x) {
  return std::min((x - Vec3(0, 0, -0.09)).norm(), (x - Vec3(0, 0, 0.09)).norm()) - radius;
}

}  // namespace

TEST_CASE_TEMPLATE("pinch: what lies between two balls that overlap rests there", Real, float, double) {
  Scene scene;
  for (const Vec3& place : {Vec3(0.01, 0.003, 0.004), Vec3(0.0, 0.03, 0.0), Vec3(0.02, -0.01, -0.008)})
    scene.add_particle(0.01, place);
  scene.effects = {Gravity{}};
  for (const Collider& one : overlapping_balls()) scene.effects.push_back(one);
  Simulation<Real> simulation(scene, frames);
  for (int i = 0; i < 60; ++i) {
    REQUIRE(simulation.step().flags == flag_none);
    for (Index p = 0; p < 3; ++p) {
      CHECK(velocity(simulation, p).norm() < 1e-3);
      CHECK((position(simulation, p) - scene.particles.position[p]).norm() < 1e-5);
    }
  }
}

TEST_CASE("pinch: it goes with the mean motion of the solids, and is let go when they go apart") {
  Scene scene;
  scene.add_particle(0.01, Vec3::Zero());
  scene.effects = {ball({0.0, 0.0, -0.105}), ball({0.0, 0.0, 0.105}, {{0.0, Vec3::Zero(), 0.0},
                                                                      {0.5, Vec3(0, 0, -0.025), 0.0},
                                                                      {1.0, Vec3(0, 0, 0.02), 0.0}})};
  Simulation<double> simulation(scene, frames);
  REQUIRE(simulation.step(20).ok());
  CHECK(velocity(simulation, 0).z() == doctest::Approx(-0.025));  // half of the ball's
  REQUIRE(simulation.step(40).ok());
  const Vec3 x = position(simulation, 0);
  CHECK((x - Vec3(0, 0, -0.105)).norm() - radius > 0.999 * thickness);
  CHECK((x - Vec3(0, 0, 0.125)).norm() - radius > 0.999 * thickness);
  CHECK(velocity(simulation, 0).norm() < 0.1);
}

TEST_CASE("pinch: what comes to lie in a corner lies outside of both solids, and slides along it") {
  for (const double opening : {40.0, 90.0, 120.0}) {
    const double half = 0.5 * opening * std::numbers::pi / 180.0, along = 1.0;
    Scene scene;
    scene.add_particle(0.01, Vec3(0.002, 0.05, 0.0));
    scene.effects = {Gravity{{0.0, -9.81, along}}};
    std::vector<Vec3> normals;
    for (const double side : {-1.0, 1.0}) {
      normals.emplace_back(side * std::cos(half), std::sin(half), 0.0);
      scene.effects.push_back(Collider{.shape = PlaneShape{normals.back(), 0.0}, .thickness = thickness});
    }
    Simulation<double> simulation(scene, {.step = 1e-3, .threads = 1});
    REQUIRE(simulation.step(1000).ok());
    for (const Vec3& normal : normals) CHECK(normal.dot(position(simulation, 0)) > 0.99 * thickness);
    CHECK(position(simulation, 0).z() == doctest::Approx(0.5 * along).epsilon(0.01));
  }
}

TEST_CASE("pinch: a wall that pushes along a floor keeps what it pushes out of both") {
  Scene scene;
  scene.add_particle(0.01, Vec3(0.05, thickness, 0.0));
  scene.effects = {Gravity{}, Collider{.shape = PlaneShape{}, .thickness = thickness, .friction = 0.5},
                   Collider{.shape = PlaneShape{Vec3::UnitX(), 0.0},
                            .thickness = thickness,
                            .path = {{0.0, Vec3::Zero(), 0.0}, {1.0, Vec3(0.5, 0.0, 0.0), 0.0}}}};
  Simulation<double> simulation(scene, frames);
  for (int i = 1; i <= 60; ++i) {
    REQUIRE(simulation.step().ok());
    CHECK(position(simulation, 0).y() > 0.999 * thickness);
    CHECK(position(simulation, 0).x() > 0.5 * i / 60.0 + 0.999 * thickness);
  }
}

TEST_CASE("pinch: cloth between two balls does not jitter there, and has gained nothing after it") {
  const Scene scene = squeezed_cloth();
  Settings settings = frames;
  settings.method = BackwardEuler{};
  Simulation<double> simulation(scene, settings);
  const double energy = simulation.energy().total();
  std::size_t pinched = 0;
  for (int i = 1; i <= 36; ++i) {
    REQUIRE(simulation.step().ok());
    if (i < 24) continue;
    for (Index p = 0; p < scene.particles.size(); ++p) {
      if (distance_to_balls(position(simulation, p)) > 0.0) continue;
      CHECK(velocity(simulation, p).norm() < 1e-3);
      ++pinched;
    }
  }
  CHECK(pinched > 100);
  CHECK(simulation.energy().elastic < 0.05);
  REQUIRE(simulation.step(40).ok());
  CHECK(simulation.energy().total() < energy);
  CHECK(count_crossings(simulation, scene) == 0);
}

TEST_CASE_TEMPLATE("pinch: the same bits on 1, 2 and 5 threads", Real, float, double) {
  const Scene scene = squeezed_cloth();
  std::vector<std::uint64_t> hashes;
  for (const unsigned threads : {1u, 2u, 5u}) {
    Simulation<Real> simulation(
        scene, {.method = Xpbd{}, .step = 1.0 / 60.0, .executor = std::make_shared<FineExecutor>(threads)});
    REQUIRE(simulation.step(30).ok());
    hashes.push_back(simulation.state_hash());
  }
  CHECK(hashes[1] == hashes[0]);
  CHECK(hashes[2] == hashes[0]);
}
