#include <doctest/doctest.h>

#include <cmath>

#include <hooke/hooke.h>

#include "effects/forces_of_scene.h"

using namespace hooke;
using namespace hooke::test;

namespace {

Vec3 position_of(const Simulation<double>& simulation, Index particle) {
  std::vector<Vec3> x(simulation.particle_count());
  simulation.copy_positions(x[0].data(), sizeof(Vec3));
  return x[particle];
}

/// A spring of 0.5 m between two pins 0.65 m apart: elastic strain 0.3.
Scene held_spring(double rate) {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  scene.add_particle(1.0, Vec3(0.65, 0, 0));
  scene.add_spring(0, 1, 100.0, 0.5);
  scene.pin(0);
  scene.pin(1);
  scene.effects = {Plasticity{.yield = 0.1, .rate = rate}};
  return scene;
}

Scene creeping_sheet() {
  Scene scene;
  add(scene, ClothGrid{.columns = 9, .rows = 7, .spacing = 0.1, .damping = 0.05});
  for (Vec3& x : scene.particles.position) x *= 1.4;
  scene.effects = {Plasticity{.yield = 0.05, .rate = 20.0}, Drag{1e-3}};
  return scene;
}

}  // namespace

TEST_CASE("plasticity: a held spring relaxes to its yield strain as the exponential says") {
  Simulation<double> simulation(held_spring(2.0), {.step = 1e-2});
  for (int i = 1; i <= 10; ++i) {
    REQUIRE(simulation.step(10).ok());
    const double elastic = 0.1 + 0.2 * std::exp(-2.0 * 0.1 * i);
    const double energy = simulation.energy().total(), expected = 0.5 * 100.0 * std::pow(0.5 * elastic, 2);
    CHECK(energy == doctest::Approx(expected).epsilon(1e-9));
    CHECK(simulation.snapshot().effects.at(0) == doctest::Approx(0.5 * (0.3 - elastic)).epsilon(1e-9));
  }
}

TEST_CASE("plasticity: under a constant force a spring creeps evenly, by every method") {
  // Elastic strain m g / (k l0) = 0.2, yield 0.1, rate 0.5: 0.5 * 0.1 * 0.5 m = 0.025 m in a second.
  for (const Method& method : all_methods) {
    CAPTURE(to_string(method));
    if (std::holds_alternative<DormandPrince>(method)) continue;
    Scene scene;
    scene.add_particle(1.0, Vec3::Zero());
    scene.add_particle(1.0, Vec3(0, -0.6, 0));
    scene.add_spring(0, 1, 100.0, 0.5, 15.0);
    scene.pin(0);
    scene.effects = {Gravity{{0, -10, 0}}, Plasticity{.yield = 0.1, .rate = 0.5}};
    Simulation<double> simulation(scene, {.method = method, .step = 1e-3});
    REQUIRE(simulation.step(500).ok());
    const double before = position_of(simulation, 1).y();
    REQUIRE(simulation.step(1000).ok());
    CHECK(before - position_of(simulation, 1).y() == doctest::Approx(0.025).epsilon(0.02));
  }
}

TEST_CASE("plasticity: energy, force and derivative agree with springs that have crept") {
  ForcesOfScene scene(creeping_sheet());
  for (std::size_t s = 0; s < scene.state().memory.size(); ++s)
    scene.state().memory[s] = 0.02 * std::sin(double(s));
  scene.shake(0.02, 0.0, 1);
  Scene springs = creeping_sheet();
  springs.effects.clear();
  ForcesOfScene linear(springs);
  linear.set_positions(scene.positions());
  const Eigen::VectorXd force = scene.forces_at_time(0.0) - linear.forces_at_time(0.0);
  CHECK((forces_from_energy(scene, 1e-5) - force).norm() < 1e-6 * force.norm());
  const Eigen::VectorXd direction = random_direction(scene.state().size(), 2);
  const Eigen::VectorXd product = scene.product(direction, {1.0, 0.0}, Curvature::exact);
  const Eigen::VectorXd change =
      product_from_forces(scene, direction, 1e-6) - product_from_forces(linear, direction, 1e-6);
  CHECK((change - product).norm() < 1e-6 * product.norm());
}

TEST_CASE("plasticity: energy falls, and a snapshot goes on with the same bits on any number of threads") {
  Simulation<double> whole(creeping_sheet(), {.step = 1e-4, .threads = 1});
  const double energy = whole.energy().total();
  REQUIRE(whole.step(200).ok());
  const Snapshot<double> snapshot = whole.snapshot();
  REQUIRE(whole.step(200).ok());
  CHECK(whole.energy().total() < energy);
  CHECK(whole.snapshot().effects != snapshot.effects);
  Simulation<double> restored(creeping_sheet(), {.step = 1e-4, .threads = 3});
  restored.restore(snapshot);
  REQUIRE(restored.step(200).ok());
  CHECK(restored.state_hash() == whole.state_hash());
  CHECK(restored.snapshot().effects == whole.snapshot().effects);
}

TEST_CASE("plasticity: creep ends at its largest, and with rate zero there is none") {
  Scene scene = held_spring(1000.0);
  scene.effects = {Plasticity{.yield = 0.0, .rate = 1000.0, .largest = 0.25}};
  Simulation<double> simulation(scene, {.step = 1e-2});
  REQUIRE(simulation.step(100).ok());
  CHECK(simulation.snapshot().effects.at(0) == 0.125);
  CHECK(Simulation<double>(held_spring(0.0), {}).snapshot().effects.empty());
  scene.effects = {Plasticity{.largest = 1.0}};
  CHECK(validate(scene)[0].message().find("largest is 1") != std::string::npos);
}
