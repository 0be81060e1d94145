#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include <hooke/hooke.h>

#include "fine_executor.h"
#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

// XPBD meets solids in each of its substeps.

namespace {

constexpr double g = 9.81, frame = 1.0 / 60.0;

/// A stiff cloth that lies on a plane, with friction; one corner has been nudged.
Scene flat_cloth(double friction) {
  Scene scene;
  const GridParticles cloth = add(scene, ClothGrid{.columns = 12, .rows = 12});
  for (Vec3& place : scene.particles.position) place = {place.x(), 0.0, place.y()};
  scene.particles.velocity.assign(scene.particles.size(), Vec3::Zero());
  scene.particles.velocity[cloth.at(0, 0)].x() = 0.01;
  scene.effects = {Gravity{{0.0, -g, 0.0}}, Collider{.friction = friction}};
  return scene;
}

/// A soft block that stands on a plane, in something viscous.
Scene block_on_plane() {
  Scene scene;
  add(scene, Block{.nx = 6, .ny = 6, .nz = 6});
  scene.effects = {Gravity{{0.0, -g, 0.0}}, Drag{.coefficient = 0.2}, Collider{.friction = 0.3}};
  return scene;
}

double fastest(const Simulation<double>& simulation) {
  double most = 0.0;
  for (Index i = 0; i < simulation.state().x.size(); ++i)
    most = std::max(most, velocity(simulation, i).norm());
  return most;
}

}  // namespace

TEST_CASE("xpbd: stiff cloth that lies on a plane with friction comes to rest, with steps of a frame") {
  for (const std::uint64_t substeps : {1, 5, 20, 60}) {
    for (const std::uint64_t iterations : {1, 5}) {
      CAPTURE(substeps);
      CAPTURE(iterations);
      const Settings settings{.method = Xpbd{.substeps = substeps, .iterations = iterations}, .step = frame};
      Simulation<double> simulation(flat_cloth(0.3), settings);
      REQUIRE(simulation.step(30).ok());
      CHECK(fastest(simulation) < 1e-9);
      CHECK(simulation.energy().elastic < 1e-9);
    }
  }
}

TEST_CASE("xpbd: a block stands on its springs as by Verlet's method, with steps of a frame") {
  const auto sunk = [](const Method& method, double step) {
    const Scene scene = block_on_plane();
    Simulation<double> simulation(scene, {.method = method, .step = step});
    REQUIRE(simulation.step(std::uint64_t(std::lround(1.0 / step))).ok());
    double sum = 0.0;
    for (Index i = 0; i < simulation.state().x.size(); ++i)
      sum += scene.particles.position[i].y() - position(simulation, i).y();
    return sum / double(simulation.state().x.size());
  };
  const double by_springs = sunk(Verlet{}, 1e-3);
  CHECK(by_springs > 3e-4);
  CHECK(std::abs(sunk(Xpbd{}, frame) - by_springs) < 1e-4);
}

TEST_CASE("xpbd: cloth that falls on solids gets the same bits on any number of threads") {
  Scene scene = flat_cloth(0.4);
  scene.effects.push_back(Collider{.shape = SphereShape{{0.1, 0.05, 0.1}, 0.06},
                                   .friction = 0.4,
                                   .path = {{0.0, {0, 0, 0}, 0.0}, {0.5, {0.05, 0.02, 0}, 90.0}}});
  for (Vec3& place : scene.particles.position) place.y() = 0.13;
  const auto hash = [&](unsigned threads) {
    Simulation<float> simulation(
        scene, {.method = Xpbd{}, .step = frame, .executor = std::make_shared<FineExecutor>(threads)});
    REQUIRE(simulation.step(20).ok());
    return simulation.state_hash();
  };
  CHECK(hash(1) == hash(3));
}
