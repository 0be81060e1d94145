#include <doctest/doctest.h>

#include <atomic>
#include <limits>

#include <hooke/hooke.h>

#include "irregular_mesh.h"
#include "scenes.h"
#include "text.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// F = -k x - c v, and a pull on particle 5.
void pull(const ParticleBatch& batch) {
  for (std::size_t i = 0; i < batch.particle.size(); ++i) {
    batch.fx[i] += -3.0 * batch.x[i] - 0.1 * batch.vx[i];
    batch.fy[i] += -3.0 * batch.y[i] - 0.1 * batch.vy[i];
    batch.fz[i] += -3.0 * batch.z[i] - 0.1 * batch.vz[i];
    if (batch.particle[i] == 5) batch.fx[i] += 0.5 * batch.time;
  }
}

Scene cloth() {
  Scene scene;
  const auto grid = add(scene, ClothGrid{.columns = 20, .rows = 13, .spacing = 0.05});
  scene.pin(grid.at(0, 0));
  return scene;
}

}  // namespace

TEST_CASE("an effect of the user's own gives the same, called in parallel and once") {
  std::vector<Vec3> ends;
  for (const bool parallel : {true, false}) {
    Scene scene = cloth();
    scene.effects = {
        Gravity{}, CustomEffect{.title = "springs to the origin", .add_forces = pull, .parallel = parallel}};
    for (const Method& method : {Method(SymplecticEuler{}), Method(RungeKutta4{}), Method(BackwardEuler{})}) {
      Simulation<double> simulation(scene, {.method = method, .step = 1e-3, .threads = 3});
      REQUIRE(simulation.step(50).ok());
      ends.push_back(position(simulation, 5));
    }
  }
  for (std::size_t i = 0; i < 3; ++i) CHECK(ends[i].isApprox(ends[i + 3], 1e-12));
  CHECK((ends[0] - ends[1]).norm() < 1e-2);  // the methods' own errors
}

TEST_CASE("an effect of the user's own equals the engine's of the same formula") {
  Scene engine = cloth(), own = cloth();
  engine.effects = {Gravity{}, Drag{0.01}};
  own.effects = {CustomEffect{.title = "weight and drag", .add_forces = [](const ParticleBatch& batch) {
                                for (std::size_t i = 0; i < batch.particle.size(); ++i) {
                                  if (batch.mass[i] < std::numeric_limits<double>::infinity())
                                    batch.fy[i] -= 9.81 * batch.mass[i];
                                  batch.fx[i] -= 0.01 * batch.vx[i];
                                  batch.fy[i] -= 0.01 * batch.vy[i];
                                  batch.fz[i] -= 0.01 * batch.vz[i];
                                }
                              }}};
  Simulation<double> a(engine, {.step = 1e-3}), b(own, {.step = 1e-3});
  REQUIRE(a.step(100).ok());
  REQUIRE(b.step(100).ok());
  for (Index i = 0; i < 260; ++i) CHECK((position(a, i) - position(b, i)).norm() < 1e-11);
}

TEST_CASE(
    "the plan shows an effect of the user's own by its title, and a function that is not set is a fault") {
  Scene scene = cloth();
  scene.effects = {CustomEffect{.title = "magnet", .add_forces = pull}};
  const Simulation<float> simulation(scene, {.step = 1e-3});
  bool shown = false;
  for (const Stage& stage : simulation.plan().stages) shown = shown || stage.name == "magnet";
  CHECK(shown);
  scene.effects = {CustomEffect{}};
  REQUIRE(validate(scene).size() == 1);
  CHECK(contains(validate(scene)[0].message(), "add_forces is not set"));
}

TEST_CASE("what a user's own effect gets wrong is reported with the particle") {
  for (const bool parallel : {true, false}) {
    Scene scene = cloth();
    scene.effects = {CustomEffect{.title = "broken",
                                  .add_forces =
                                      [](const ParticleBatch& batch) {
                                        for (std::size_t i = 0; i < batch.particle.size(); ++i)
                                          if (batch.particle[i] == 77)
                                            batch.fx[i] = std::numeric_limits<double>::quiet_NaN();
                                      },
                                  .parallel = parallel}};
    Simulation<float> simulation(scene, {.step = 1e-3});
    const Report report = simulation.step();
    CHECK(!report.ok());
    CHECK(report.first_bad_particle == 77);
  }
}

TEST_CASE("a function that adds nothing leaves the bits alone") {
  Scene bare = cloth(), with = cloth();
  bare.effects = {Gravity{}};
  for (const bool parallel : {true, false}) {
    with.effects = {
        Gravity{},
        CustomEffect{.title = "nothing", .add_forces = [](const ParticleBatch&) {}, .parallel = parallel}};
    Simulation<float> a(bare, {.step = 1e-3}), b(with, {.step = 1e-3});
    REQUIRE(a.step(50).ok());
    REQUIRE(b.step(50).ok());
    CHECK(a.state_hash() == b.state_hash());
  }
}
