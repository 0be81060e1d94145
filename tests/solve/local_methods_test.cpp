// What vertex block descent and XPBD have in common.

#include <doctest/doctest.h>

#include "fine_executor.h"
#include "irregular_mesh.h"
#include "solve/hard_scenes.h"
#include "solve/solver_run.h"

using namespace hooke;
using namespace hooke::test;

namespace {

const Method local_methods[] = {Xpbd{.substeps = 3}, Xpbd{.substeps = 2, .iterations = 3},
                                VertexBlockDescent{.iterations = 10},
                                VertexBlockDescent{.iterations = 10, .acceleration = 0.75}};

Scene irregular_cloth() {
  Scene scene;
  const MeshParticles cloth = add(scene, irregular_mesh(30));
  for (Index particle : furthest_along(scene, cloth.first, cloth.count, Vec3(0, 1, 0), 0.05))
    scene.pin(particle);
  scene.effects = {Gravity{}, Drag{1e-4}, GroundPlane{.height = -0.9, .stiffness = 50.0}};
  return scene;
}

}  // namespace

TEST_CASE_TEMPLATE("local methods: same bits on 1, 2 and 5 threads", Real, float, double) {
  for (const Scene& scene : {disturbed_cloth(0.7, 0.3, 0.01), irregular_cloth(), RandomNetwork(3).make()}) {
    for (const Method& method : local_methods) {
      CAPTURE(to_string(method));
      SolverRun<Real, Method> one(scene, method, std::make_shared<FineExecutor>(1));
      for (int step = 0; step < 5; ++step) one.step(0.01);
      for (const unsigned threads : {2u, 5u}) {
        SolverRun<Real, Method> many(scene, method, std::make_shared<FineExecutor>(threads));
        for (int step = 0; step < 5; ++step) many.step(0.01);
        CHECK(same_bits(one.now, many.now));
      }
    }
  }
}

TEST_CASE_TEMPLATE("local methods: units scaled by powers of two give the same bits", Real, float, double) {
  constexpr double length = 8.0, mass = 0.25, time = 4.0;
  Scene scene = disturbed_cloth(0.8, 0.3, 0.01), scaled = scene;
  for (Vec3& position : scaled.particles.position) position *= length;
  for (Vec3& velocity : scaled.particles.velocity) velocity *= length / time;
  for (double& one : scaled.particles.mass) one *= mass;
  for (double& stiffness : scaled.springs.stiffness) stiffness *= mass / (time * time);
  for (double& damping : scaled.springs.damping) damping *= mass / time;
  for (double& rest_length : scaled.springs.rest_length) rest_length *= length;
  const Vec3 g(0, -9.81, 0);
  scene.effects = {Gravity{g}, Drag{0.01}};
  scaled.effects = {Gravity{g * (length / (time * time))}, Drag{0.01 * mass / time}};
  for (const Method& method : local_methods) {
    CAPTURE(to_string(method));
    SolverRun<Real, Method> run(scene, method), of_scaled(scaled, method);
    for (int step = 0; step < 10; ++step) {
      run.step(1.0 / 64.0);
      of_scaled.step(time / 64.0);
    }
    bool same = true;
    for (std::size_t i = 0; i < run.now.size(); ++i) {
      same = same && of_scaled.now.position(i) == Real(length) * run.now.position(i);
      same = same && of_scaled.now.velocity(i) == Real(length / time) * run.now.velocity(i);
    }
    CHECK(same);
  }
}

TEST_CASE("local methods: of a cloth thrown at random into a cube next to no energy is left, nor ever more") {
  Scene scene;
  add(scene, ClothGrid{.columns = 16, .rows = 16, .spacing = 1.0 / 15.0, .stretch = 100.0, .shear = 50.0});
  for (const Method& method : {Method(Xpbd{}), Method(VertexBlockDescent{})}) {
    for (const std::uint32_t seed : {0u, 1u, 2u}) {
      CAPTURE(to_string(method));
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> unit(0.0, 1.0);
      for (Vec3& position : scene.particles.position) position = {unit(random), unit(random), unit(random)};
      Simulation<double> simulation(scene, {.method = method, .threads = 1});
      const double start = simulation.energy().total();
      for (int step = 0; step < 300; ++step) {
        REQUIRE(simulation.step().ok());
        CHECK(simulation.energy().total() < start);
      }
      CHECK(simulation.energy().total() < 1e-3 * start);
    }
  }
}

TEST_CASE("local methods: fields that make no sense are refused, and the fault says what to give") {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const Method bad[] = {Xpbd{.substeps = 0},
                        Xpbd{.substeps = ~std::uint64_t{0}},
                        Xpbd{.iterations = 0},
                        Xpbd{.iterations = ~std::uint64_t{0}},
                        VertexBlockDescent{.iterations = 0},
                        VertexBlockDescent{.iterations = ~std::uint64_t{0}},
                        VertexBlockDescent{.tolerance = -1.0},
                        VertexBlockDescent{.tolerance = nan},
                        VertexBlockDescent{.tolerance = infinity},
                        VertexBlockDescent{.acceleration = 1.0},
                        VertexBlockDescent{.acceleration = -0.1},
                        VertexBlockDescent{.acceleration = nan}};
  for (const Method& method : bad) {
    const std::vector<Fault> faults = validate(one_particle(), {.method = method});
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].element.find(to_string(method)) != std::string::npos);
    CHECK(faults[0].remedy.find("give") == 0);
    CHECK_THROWS_AS(Simulation<float>(one_particle(), {.method = method}), SceneError);
  }
}
