#include <doctest/doctest.h>

#include "allocation/counted_memory.h"
#include "irregular_mesh.h"
#include "scenes.h"

using namespace hooke;
using test::allocations;

TEST_CASE_TEMPLATE("a step allocates nothing, in any mode, by any method, on any number of threads", Real,
                   float, double) {
  Scene grid = test::hung_cloth(80, 60, 0.001), mesh;
  grid.pin(40, {{0.0, {0, 0, 0}}, {1.0, {0, 0, 0.1}}});
  add(mesh, test::irregular_mesh(60));
  mesh.effects = {Gravity{}, GroundPlane{.height = -1.0, .stiffness = 10.0}};
  for (const Scene& scene : {grid, mesh}) {
    for (auto accumulation : accumulations) {
      for (const Method& method : all_methods) {
        if (!can_accumulate(method, accumulation)) continue;
        for (unsigned threads : {1u, 2u}) {
          CAPTURE(to_string(method));
          Simulation<Real> simulation(
              scene, {.method = method, .step = 1e-4, .accumulation = accumulation, .threads = threads});
          REQUIRE(simulation.step(20).ok());
          const std::size_t before = allocations();
          REQUIRE(before > 0);
          const Report report = simulation.step(50);
          CHECK(allocations() == before);
          CHECK(report.ok());
        }
      }
    }
  }
}

TEST_CASE_TEMPLATE("a step with effects on stretch allocates nothing", Real, float, double) {
  Scene scene = test::hung_cloth(20, 20, 0.001);
  scene.effects.insert(
      scene.effects.end(),
      {Cables{{0, 5, 9}}, StiffeningSprings{1.0, 1.0, {1, 2}},
       Plasticity{.yield = 0.0, .rate = 1.0, .springs = {3, 4}}, StrainLimit{.limit = 0.001}, Tethers{},
       Collider{.shape = SphereShape{{0.2, -0.2, 0.0}, 0.1}}, FrameAttachment{.particles = {300, 301}},
       Stitch{.first = {200}, .second = {280}, .closing_time = 1.0}});
  for (unsigned threads : {1u, 2u}) {
    Simulation<Real> simulation(scene, {.step = 1e-3, .threads = threads});
    REQUIRE(simulation.step(20).ok());
    const std::size_t before = allocations();
    const std::size_t attachment = scene.effects.size() - 2;
    simulation.move_frame(attachment, {{0.0, 0.0, 0.01}, Eigen::Quaterniond::Identity()});
    const Report report = simulation.step(50);
    CHECK(simulation.carried_force(attachment).force.norm() > 0.0);
    CHECK(allocations() == before);
    CHECK(report.limit_sweeps > 0);
  }
}
