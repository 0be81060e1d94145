// What sleeps and what it touches: solids that carry it, what hits it, what feels it.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <hooke/hooke.h>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr Index side = 6;
constexpr double radius = 0.01;

/// A cloth of 0.1 m that lies flat; its first particle.
Index lay_cloth(Scene& scene, const Vec3& place) {
  ClothGrid cloth{.columns = side, .rows = side, .spacing = 0.02, .areal_density = 0.5, .stretch = 50.0};
  cloth.shear = 25.0, cloth.damping = 0.01;
  cloth.placement = {.translation = place, .rotation_axis = {1.0, 0.0, 0.0}, .rotation_degrees = -90.0};
  return add(scene, cloth).first;
}

template <class Real>
void step_until_asleep(Simulation<Real>& simulation, Index particle) {
  for (int i = 0; i < 400 && !simulation.is_asleep(particle); ++i) REQUIRE(simulation.step().ok());
  REQUIRE(simulation.is_asleep(particle));
}

std::vector<Method> explicit_methods_for_contact() {
  return {SymplecticEuler{}, RungeKutta4{}, Verlet{}, BlanesMoan{}};
}

/// The same run of a scene, with parts that may sleep and without.
template <class Real>
std::pair<Simulation<Real>, Simulation<Real>> with_sleep_and_without(Scene scene, const Settings& settings) {
  Simulation<Real> without(scene, settings);
  scene.effects.push_back(Sleep{.speed = 1e-3, .time = 0.05});
  return {Simulation<Real>(scene, settings), std::move(without)};
}

}  // namespace

TEST_CASE_TEMPLATE("a solid that goes away under a sleeper takes it along, or lets it fall", Real, float,
                   double) {
  for (const double top : {0.0, 0.3, -0.3, 1.7}) {
    for (const Vec3& way : {Vec3(0.0, -0.02, 0.0), Vec3(0.02, 0.0, 0.0)}) {
      CAPTURE(top);
      CAPTURE(way.y());
      Scene scene;
      lay_cloth(scene, {0.0, top + 1e-3, 0.0});
      scene.effects = {
          Gravity{},
          Collider{
              .shape = BoxShape{{0.0, top - 0.1, 0.0}, {1.0, 0.1, 1.0}}, .thickness = 1e-3, .friction = 0.5},
          Sleep{.speed = 2e-3, .time = 0.1}};
      Simulation<Real> simulation(scene, {.step = 5e-3, .threads = 1});
      step_until_asleep(simulation, 0);
      const Vec3 before = position(simulation, 0).template cast<double>();
      for (int i = 1; i <= 40; ++i) {
        simulation.move_frame(1, {i / 40.0 * way, Eigen::Quaterniond::Identity()});
        REQUIRE(simulation.step().ok());
        REQUIRE(!simulation.is_asleep(0));
      }
      const Vec3 moved = position(simulation, 0).template cast<double>() - before;
      CHECK(moved.dot(way) > 0.8 * way.squaredNorm());
    }
  }
}

TEST_CASE("a grain that hits a sleeper and leaves it within one step shares its momentum with it") {
  Scene scene;
  scene.add_particle(0.01, Vec3::Zero());
  scene.add_particle(0.01, {-0.1, 0.0, 0.0}, {0.5, 0.0, 0.0});
  scene.effects = {ParticleContact{.radius = {radius}, .stiffness = 1e5, .damping = 0.01}};
  for (const Method& method : explicit_methods_for_contact()) {
    CAPTURE(to_string(method));
    auto [with, without] =
        with_sleep_and_without<double>(scene, {.method = method, .step = 1.0 / 60.0, .threads = 1});
    step_until_asleep(with, 0);
    while (with.is_asleep(0)) {
      REQUIRE(with.step().ok());
      REQUIRE(with.time() < 0.4);
    }
    REQUIRE(without.step(with.steps()).ok());
    CHECK(velocity(with, 0).x() == doctest::Approx(0.5).epsilon(0.05));
    CHECK(std::abs(velocity(with, 1).x()) < 0.025);
    CHECK(with.state_hash() == without.state_hash());
  }
}

TEST_CASE("a cloth that hits a sleeper moves both as if that had been awake") {
  Scene scene;
  const Index below = lay_cloth(scene, Vec3::Zero()), above = lay_cloth(scene, {0.003, 0.15, 0.004});
  scene.particles.velocity.assign(scene.particles.size(), Vec3::Zero());
  for (Index i = above; i < scene.particles.size(); ++i) scene.particles.velocity[i] = {0.0, -1.0, 0.0};
  scene.effects = {SelfCollision{.thickness = 2e-3, .friction = 0.2}};
  for (const Method& method : explicit_methods_for_contact()) {
    CAPTURE(to_string(method));
    auto [with, without] =
        with_sleep_and_without<double>(scene, {.method = method, .step = 1.0 / 60.0, .threads = 1});
    CHECK(with.plan().substeps > 1);
    step_until_asleep(with, below);
    while (with.is_asleep(below)) {
      REQUIRE(with.step().ok());
      REQUIRE(with.time() < 0.3);
    }
    REQUIRE(without.step(with.steps()).ok());
    // Not the same bits: what rounding strains in springs stops where they fall asleep.
    CHECK(with.momentum().y() == doctest::Approx(without.momentum().y()).epsilon(1e-9));
    double furthest = 0.0;
    for (Index i = 0; i < scene.particles.size(); ++i)
      furthest = std::max(furthest, (position(with, i) - position(without, i)).norm());
    CHECK(furthest < 1e-9);
  }
}

TEST_CASE("cloth that has fallen on cloth sleeps after half a second at rest, by every method") {
  for (const Method& method : {Method{SymplecticEuler{}}, Method{Verlet{}}, Method{BackwardEuler{}},
                               Method{ProjectiveDynamics{}}, Method{Xpbd{}}, Method{VertexBlockDescent{}}}) {
    CAPTURE(to_string(method));
    Scene scene;
    lay_cloth(scene, {0.0, 1e-3, 0.0});
    lay_cloth(scene, {0.0, 0.03, 0.003});
    scene.effects = {Gravity{}, Collider{.shape = PlaneShape{}, .thickness = 1e-3, .friction = 0.5},
                     SelfCollision{.thickness = 2e-3, .friction = 0.3}, Sleep{.time = 0.5}};
    Simulation<double> simulation(scene, {.method = method, .step = 5e-3, .threads = 1});
    REQUIRE(simulation.step(160).ok());  // it falls for 0.07 s
    CHECK(simulation.is_asleep(0));
    CHECK(simulation.is_asleep(side * side));
  }
}

TEST_CASE("sleepers are felt where they are by a run that was restored") {
  // Whole blocks of grains slide aside and fall asleep; one more is then pushed through where they were.
  Scene scene;
  const Index one = 48;
  for (Index i = 0; i < one; ++i) scene.add_particle(0.01, {0.05 + 0.03 * i, radius, 0.0}, {0.0, 0.0, 1.0});
  scene.add_particle(0.01, {-0.03, radius, 0.0});
  scene.effects = {Gravity{}, Collider{.shape = PlaneShape{}, .thickness = radius, .friction = 0.5},
                   ParticleContact{.radius = {radius}, .stiffness = 100.0, .damping = 0.1},
                   Sleep{.speed = 2e-3, .time = 0.05}};
  for (const Method& method : {Method(SymplecticEuler{}), Method(RungeKutta4{}), Method(Verlet{}),
                               Method(BackwardEuler{}), Method(Xpbd{}), Method(VertexBlockDescent{})}) {
    CAPTURE(to_string(method));
    const Settings settings{.method = method, .step = 2e-3, .threads = 1};
    Simulation<double> whole(scene, settings), restored(scene, settings);
    step_until_asleep(whole, 0);
    step_until_asleep(whole, one);
    REQUIRE(position(whole, 0).z() > 0.08);
    restored.restore(whole.snapshot());
    for (Simulation<double>* simulation : {&whole, &restored}) {
      simulation->apply_impulse(one, {0.01, 0.0, 0.0});
      REQUIRE(simulation->step(100).ok());
    }
    CHECK(position(whole, one).x() > 0.06);
    CHECK(whole.is_asleep(0));
    CHECK(restored.state_hash() == whole.state_hash());
  }
}

TEST_CASE("what cannot be put right of sleepers does not move them") {
  Scene scene;
  Method method = BackwardEuler{};
  Index sleepers = 0, awake = 0;  // the first of these are to sleep, and one that something is
  SUBCASE("a strain limit") {
    method = SymplecticEuler{};
    for (Index i = 0; i < 30; ++i) {
      scene.add_particle(0.01, {0.0, -0.05 * i, 0.0});
      if (i > 0) scene.add_spring(i - 1, i, 50.0, 0.05, 0.2);
    }
    scene.pin(0);
    sleepers = 30;
    scene.pin(scene.add_particle(0.1, {1.0, 0.0, 0.0}));
    awake = scene.add_particle(0.1, {1.3, 0.0, 0.0});
    scene.add_spring(awake - 1, awake, 500.0, 0.3, 0.01);
    scene.effects = {Gravity{}, Drag{0.05}, StrainLimit{.limit = 0.01, .sweeps = 4},
                     Sleep{.speed = 2e-2, .time = 0.2}};
  }
  SUBCASE("pieces that cross") {
    const Index lying = lay_cloth(scene, Vec3::Zero());
    ClothGrid upright{.columns = side, .rows = side, .spacing = 0.02, .areal_density = 0.5, .stretch = 50.0};
    upright.shear = 25.0, upright.damping = 0.05;
    upright.placement = {.translation = {0.005, 0.045, 0.056}};
    const Index standing = add(scene, upright).first;
    for (Index i = 0; i < side; ++i) {
      for (const Index first : {lying, standing})
        scene.pin(first + i), scene.pin(first + side * (side - 1) + i);
    }
    // Near them, so that they are looked at.
    sleepers = Index(scene.particles.size());
    awake = lay_cloth(scene, {0.118, 0.0, 0.0});
    scene.particles.velocity.assign(scene.particles.size(), Vec3::Zero());
    for (Index i = awake; i < scene.particles.size(); ++i) scene.particles.velocity[i] = {-0.03, 0.0, 0.0};
    scene.effects = {SelfCollision{.thickness = 2e-3, .swept = false, .untangle = true},
                     Sleep{.speed = 2e-2, .time = 0.05}};
  }
  Simulation<double> simulation(scene, {.method = method, .step = 5e-3, .threads = 1});
  for (int n = 0; n < 400 && simulation.step(0).particles_asleep < sleepers; ++n) simulation.step();
  REQUIRE(simulation.step(0).particles_asleep == sleepers);
  std::vector<Vec3> before;
  for (Index i = 0; i < sleepers; ++i) before.push_back(position(simulation, i));
  for (int n = 0; n < 50; ++n) {
    REQUIRE(simulation.step().ok());
    REQUIRE(simulation.step(0).particles_asleep == sleepers);
    REQUIRE(!simulation.is_asleep(awake));
    for (Index i = 0; i < sleepers; ++i) {
      CHECK(position(simulation, i) == before[i]);
      CHECK(velocity(simulation, i).isZero(0.0));
    }
  }
}
