// Runs of scenes with colliders that have a stiffness: methods, frames that move, plans, threads, snapshots.

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <hooke/hooke.h>

#include "effects/penalty_scenes.h"
#include "effects/solid_meshes.h"
#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

std::vector<Method> methods_for_contact() {
  std::vector<Method> methods;
  for (const Method& method : all_methods) {
    if (!std::holds_alternative<DormandPrince>(method)) methods.push_back(method);
  }
  return methods;
}

std::uint64_t substeps_of(const Scene& scene) {
  return Simulation<double>(scene, {.step = 0.01}).plan().substeps;
}

}  // namespace

TEST_CASE("penalty: it rests at the same depth by every method, in float and in double") {
  constexpr double k = 2000.0;
  const Scene scene = one_over({.stiffness = k, .damping = 40.0}, Vec3::Zero());
  for (const Method& method : methods_for_contact()) {
    CAPTURE(to_string(method));
    const Settings settings{.method = method, .step = 5e-3};
    Simulation<double> in_double(scene, settings);
    Simulation<float> in_float(scene, settings);
    REQUIRE(in_double.step(400).ok());
    REQUIRE(in_float.step(400).ok());
    CHECK(position(in_double, 0).y() == doctest::Approx(-mass * g / k).epsilon(1e-5));
    CHECK(position(in_float, 0).y() == doctest::Approx(-mass * g / k).epsilon(1e-3));
  }
}

TEST_CASE("penalty: on an incline it slides as Coulomb says, to a hundredth") {
  const double angle = M_PI / 6.0, mu = 0.3;
  const double a = g * (std::sin(angle) - mu * std::cos(angle));
  const Scene scene = one_over(incline(angle, mu), Vec3::Zero());
  for (const Method& method : methods_for_contact()) {
    CAPTURE(to_string(method));
    Simulation<double> simulation(scene, {.method = method, .step = 1e-3});
    REQUIRE(simulation.step(500).ok());
    const Vec3 before = velocity(simulation, 0);
    REQUIRE(simulation.step(500).ok());
    CHECK((velocity(simulation, 0) - before).norm() == doctest::Approx(0.5 * a).epsilon(0.01));
    CHECK(position(simulation, 0).norm() == doctest::Approx(0.5 * a).epsilon(0.02));
  }
}

TEST_CASE("penalty: what should stick creeps at m g sin / c") {
  const double angle = 0.3;
  const Collider plane = incline(angle, 0.5);
  const Scene scene = one_over(plane, Vec3::Zero());
  for (const Method& method : {Method(SymplecticEuler{}), Method(BackwardEuler{})}) {
    CAPTURE(to_string(method));
    Simulation<double> simulation(scene, {.method = method, .step = 1e-3});
    REQUIRE(simulation.step(500).ok());
    CHECK(velocity(simulation, 0).norm() ==
          doctest::Approx(mass * g * std::sin(angle) / plane.damping).epsilon(1e-3));
  }
}

TEST_CASE("penalty: a lift carries, a belt drags, by path and by host") {
  constexpr double k = 1e5;
  const Collider lift{.stiffness = k, .damping = 100.0, .path = {{0.0}, {1.0, {0.0, 0.5, 0.0}}}};
  const Collider belt{.shape = BoxShape{{0.0, -0.5, 0.0}, {9.0, 0.5, 9.0}},
                      .friction = 0.5,
                      .stiffness = k,
                      .damping = 100.0,
                      .path = {{0.0}, {1.0, {2.0, 0.0, 0.0}}}};
  for (const Method& method : {Method(SymplecticEuler{}), Method(Verlet{}), Method(RungeKutta4{}),
                               Method(BackwardEuler{}), Method(VertexBlockDescent{}), Method(Xpbd{})}) {
    CAPTURE(to_string(method));
    const Settings settings{.method = method, .step = 1e-3};
    for (const bool by_host : {false, true}) {
      CAPTURE(by_host);
      const auto run = [&](Collider collider, const Vec3& end) {
        if (by_host) collider.path.clear();
        Simulation<double> simulation(one_over(collider, {0.0, -mass * g / k, 0.0}), settings);
        for (int i = 1; i <= 300; ++i) {
          if (by_host) simulation.move_frame(1, {1e-3 * i * end, Eigen::Quaterniond::Identity()});
          REQUIRE(simulation.step(1).ok());
        }
        return std::pair(position(simulation, 0), velocity(simulation, 0));
      };
      const auto [lifted, up] = run(lift, {0.0, 0.5, 0.0});
      CHECK(lifted.y() == doctest::Approx(0.15 - mass * g / k).epsilon(1e-3));
      CHECK(up.y() == doctest::Approx(0.5).epsilon(1e-3));
      // mu g for 0.3 s: slower than the belt still.
      const auto [carried, along] = run(belt, {2.0, 0.0, 0.0});
      CHECK(along.x() == doctest::Approx(0.5 * g * 0.3).epsilon(0.01));
      CHECK(carried.x() == doctest::Approx(0.25 * g * 0.09).epsilon(0.02));
    }
  }
}

TEST_CASE("penalty: where the host lets a belt stand, it drags no more") {
  const Collider belt{.friction = 0.5, .stiffness = 1e5, .damping = 100.0};
  Simulation<double> simulation(one_over(belt, Vec3::Zero()), {.step = 1e-3});
  for (int i = 1; i <= 20; ++i) {
    simulation.move_frame(1, {{2e-3 * i, 0.0, 0.0}, Eigen::Quaterniond::Identity()});
    REQUIRE(simulation.step(1).ok());
  }
  CHECK(velocity(simulation, 0).x() > 0.05);
  REQUIRE(simulation.step(100).ok());
  CHECK(std::abs(velocity(simulation, 0).x()) < 1e-9);
}

TEST_CASE("penalty: substeps grow with the root of the stiffness, and solids add up") {
  const auto with = [](std::vector<Collider> colliders) {
    Scene scene = one_particle();
    for (Collider& collider : colliders) scene.effects.emplace_back(std::move(collider));
    return substeps_of(scene);
  };
  const Collider soft{.stiffness = 4e8}, hard{.stiffness = 4e10};
  CHECK(with({}) == 1);
  const Scene one = one_over({.stiffness = 500.0}, Vec3::Zero());
  CHECK(highest_frequency(one) == doctest::Approx(std::sqrt(500.0 / mass)).epsilon(1e-9));
  CHECK(double(with({hard})) == doctest::Approx(10.0 * double(with({soft}))).epsilon(0.05));
  CHECK(double(with({soft, soft, soft, soft})) == doctest::Approx(2.0 * double(with({soft}))).epsilon(0.1));
  CHECK(with({{.friction = 1.0}}) == 1);
  CHECK(with({{.stiffness = 1.0, .damping = 1e4}}) > 20);
}

TEST_CASE("penalty: pressed by several at once the explicit method stays stable in the steps of its plan") {
  Scene scene = one_particle();
  scene.effects = {Gravity{{0.0, -g, 0.0}}};
  for (int i = 0; i < 3; ++i)
    scene.effects.push_back(Collider{
        .shape = BoxShape{{0.0, -0.5 + 1e-7 * i, 0.0}, {1.0, 0.5, 1.0}}, .stiffness = 1e6, .damping = 50.0});
  Simulation<double> simulation(scene, {.step = 0.01});
  REQUIRE(simulation.step(500).ok());
  CHECK(velocity(simulation, 0).norm() < 1e-6);
}

TEST_CASE_TEMPLATE("penalty: the same bits on any number of threads, and from far away none", Real, float,
                   double) {
  const Scene bare = hung_cloth(40, 30, 0.001);
  Scene scene = bare, far = bare;
  std::mt19937 random(3);
  const auto unit = [&] { return double(random()) / 4294967296.0; };
  for (int i = 0; i < 20; ++i) {
    const double x = 0.8 * unit(), y = -0.6 * unit(), z = 0.1 * unit() - 0.02;
    Collider ball{.shape = SphereShape{{x, y, z}, 0.03}, .friction = 0.3, .stiffness = 2.0, .damping = 0.001};
    scene.effects.push_back(ball);
    ball.shape = SphereShape{{x, y, z + 50.0}, 0.03};
    far.effects.push_back(ball);
  }
  MeshShape mesh = bumpy_mesh(1);
  mesh.scale = 0.1;
  for (Vec3& vertex : mesh.vertices) vertex += Vec3(3.0, -3.0, 0.3);
  scene.effects.push_back(Collider{.shape = mesh,
                                   .stiffness = 5.0,
                                   .damping = 0.001,
                                   .path = {{0.0, {0, 0, 0}, 0.0}, {0.05, {0, 0, -0.1}, 90.0}}});
  for (const Method& method :
       {Method(SymplecticEuler{}), Method(BackwardEuler{}), Method(Xpbd{}), Method(VertexBlockDescent{})}) {
    CAPTURE(to_string(method));
    const auto run = [&](const Scene& what, unsigned threads) {
      Simulation<Real> simulation(what, {.method = method, .step = 1e-3, .threads = threads});
      REQUIRE(simulation.step(15).ok());
      return simulation.state_hash();
    };
    const std::uint64_t one = run(scene, 1);
    CHECK(run(scene, 3) == one);
    CHECK(run(bare, 2) != one);
    if (!solves_equations(method)) {
      Settings settings{.method = method, .step = 1e-3};
      settings.step /= double(Simulation<Real>(far, settings).plan().substeps);
      Simulation<Real> away(far, settings), none(bare, settings);
      REQUIRE(away.step(40).ok());
      REQUIRE(none.step(40).ok());
      CHECK(away.state_hash() == none.state_hash());
    }
  }
}

TEST_CASE("penalty: many are one stage; a scene without one has the plan that it had") {
  Scene scene = hung_cloth(8, 8);
  scene.effects.push_back(Collider{.shape = SphereShape{{0.0, 0.0, -2.0}, 0.5}});
  const auto names = [](const Scene& of) {
    const Simulation<float> simulation(of, {.step = 1e-3});
    std::string all;
    for (const Stage& stage : simulation.plan().stages) all += stage.name + "; ";
    return all;
  };
  const std::string before = names(scene);
  CHECK(before.find("penalty") == before.npos);
  for (int i = 0; i < 5; ++i)
    scene.effects.insert(scene.effects.begin(), Collider{.shape = SphereShape{}, .stiffness = 1.0});
  std::string after = names(scene);
  const std::string own = "collider (penalty); ";
  REQUIRE(after.find(own) != after.npos);
  after.erase(after.find(own), own.size());
  CHECK(after == before);
}

TEST_CASE("penalty: self-collision does not take it for a floor that it must not be pressed into") {
  // A sheet that lies in a penalty, below its thickness: as deep with self-collision as without.
  Scene scene;
  add(scene, ClothGrid{.columns = 6, .rows = 6, .spacing = 0.05, .stretch = 100.0, .shear = 50.0});
  for (Vec3& x : scene.particles.position) x = {x.x(), -0.001, x.y()};
  scene.effects = {Gravity{},
                   Collider{.shape = PlaneShape{}, .thickness = 0.002, .stiffness = 1.0, .damping = 0.01}};
  Scene with = scene;
  with.effects.push_back(SelfCollision{.thickness = 0.004});
  Simulation<double> one(scene, {.step = 1e-3}), other(with, {.step = 1e-3});
  REQUIRE(one.step(100).ok());
  REQUIRE(other.step(100).ok());
  CHECK(position(one, 0) == position(other, 0));
}

TEST_CASE_TEMPLATE("penalty: a restored run goes on with the same bits, frames moved by the host included",
                   Real, float, double) {
  Scene scene = hung_cloth(12, 9, 0.001);
  MeshShape mesh = bumpy_mesh(1);
  mesh.scale = 0.15;
  for (const ColliderShape& shape : {ColliderShape(SphereShape{{0.1, -0.1, 0.0}, 0.05}), ColliderShape(mesh)})
    scene.effects.push_back(Collider{.shape = shape, .friction = 0.3, .stiffness = 20.0, .damping = 0.01});
  const auto turn = [](Simulation<Real>& simulation, std::size_t effect, int steps) {
    for (int i = 0; i < steps; ++i) {
      const double time = double(simulation.steps() + 1) * simulation.settings().step;
      simulation.move_frame(effect, {Vec3(0.0, 0.0, 0.5 * time),
                                     Eigen::Quaterniond(Eigen::AngleAxisd(3.0 * time, Vec3::UnitY()))});
      REQUIRE(simulation.step(1).ok());
    }
  };
  for (const Method& method : {Method(SymplecticEuler{}), Method(VertexBlockDescent{})}) {
    Simulation<Real> whole(scene, {.method = method, .step = 1e-3}),
        other(scene, {.method = method, .step = 1e-3}), fresh(scene, {.method = method, .step = 1e-3});
    turn(whole, 2, 10);
    const Snapshot<Real> middle = whole.snapshot();
    turn(whole, 3, 10);
    other.restore(middle);
    turn(other, 3, 10);
    CHECK(other.state_hash() == whole.state_hash());
    const Snapshot<Real> start = fresh.snapshot();
    REQUIRE(fresh.step(15).ok());
    other.restore(start);
    REQUIRE(other.step(15).ok());
    CHECK(other.state_hash() == fresh.state_hash());
    CHECK(whole.state_hash() != fresh.state_hash());
    // Steps that follow a move at once or one by one.
    other.restore(whole.snapshot());
    turn(whole, 2, 1);
    turn(other, 2, 1);
    for (Simulation<Real>* one : {&whole, &other})
      one->move_frame(3, {Vec3(0.0, 0.0, 0.02), Eigen::Quaterniond::Identity()});
    REQUIRE(whole.step(6).ok());
    for (int i = 0; i < 6; ++i) REQUIRE(other.step(1).ok());
    CHECK(other.state_hash() == whole.state_hash());
  }
}

TEST_CASE("penalty: a force that is not finite stops the run, which names the particle") {
  Scene scene = one_over({.shape = SphereShape{{0.0, -0.1, 0.0}, 0.5}, .stiffness = 1e40}, Vec3::Zero());
  Simulation<float> simulation(scene, {.method = BackwardEuler{}, .step = 1e-3});
  const Report report = simulation.step(10);
  CHECK_FALSE(report.ok());
  CHECK(report.message().find("particle 0 ") != std::string::npos);
  CHECK(position(simulation, 0).isZero(0.0));
}
