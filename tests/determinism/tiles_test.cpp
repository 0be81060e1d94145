#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "irregular_mesh.h"
#include "sanitized.h"
#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

// Few: explicit Euler, which is always unstable here, must not have gone bad.
constexpr int steps = sanitized ? 8 : 60;

const std::vector<unsigned> thread_counts = sanitized ? std::vector{3u} : std::vector{1u, 2u, 3u, 7u};

/// Springs with and without damping, shift and indexed slots, a pin that moves.
std::vector<Scene> scenes() {
  Scene grid = hung_cloth(150, 70, 0.001);
  grid.pin(75, {{0.0, {0, 0, 0}}, {0.02, {0, 0, 0.05}}});
  Scene mesh;
  const MeshParticles cloth = add(mesh, irregular_mesh(110));
  mesh.pin(cloth.first, {{0.0, {0, 0, 0}}, {0.05, {0.01, 0, 0}}});
  mesh.effects = {Gravity{}, Drag{1e-5}, GroundPlane{.height = -0.9, .stiffness = 50.0}};
  return {grid, mesh};
}

template <class Real>
std::vector<Real> interpolated(const Simulation<Real>& simulation) {
  std::vector<Real> positions(3 * simulation.particle_count());
  simulation.copy_positions(positions.data(), 3 * sizeof(Real), 0.25);
  return positions;
}

/// Falls, and is blown up by a spring that is far too stiff for the step once it starts to swing.
Scene exploding() {
  Scene scene = hung_cloth(100, 60);
  const Index a = scene.add_particle(1.0, {5, 0, 0}), b = scene.add_particle(1.0, {6, 0, 0}, {0.1, 0, 0});
  scene.add_spring(a, b, 5e6, 1.0);
  return scene;
}

}  // namespace

TEST_CASE_TEMPLATE("many steps at once give the same bits as one after the other", Real, float, double) {
  for (const Scene& scene : scenes()) {
    for (const Method& method : all_methods) {
      CAPTURE(to_string(method));
      Simulation<Real> single(scene, {.method = method, .step = 1e-4, .threads = 1});
      for (int i = 0; i < steps; ++i) REQUIRE(single.step().ok());
      for (unsigned threads : thread_counts) {
        Simulation<Real> many(scene, {.method = method, .step = 1e-4, .threads = threads});
        REQUIRE(many.step(steps).ok());
        CHECK(many.state_hash() == single.state_hash());
        CHECK(many.time() == single.time());
        CHECK(interpolated(many) == interpolated(single));
      }
    }
  }
}

TEST_CASE("a step that goes bad among many is found as it is one by one") {
  const Scene scene = exploding();
  Simulation<float> single(scene, {.step = 1e-3, .unstable_step = UnstableStep::take, .threads = 1});
  Report expected;
  while (expected.ok() && expected.step < 1000) expected = single.step();
  REQUIRE_FALSE(expected.ok());
  REQUIRE(expected.step > 10);
  for (unsigned threads : {1u, 3u}) {
    Simulation<float> many(scene, {.step = 1e-3, .unstable_step = UnstableStep::take, .threads = threads});
    const Report report = many.step(10 * expected.step);
    CHECK_FALSE(report.ok());
    CHECK(report.step == expected.step);
    CHECK(report.steps_taken == expected.step - 1);
    CHECK(report.first_bad_particle == expected.first_bad_particle);
    CHECK(many.state_hash() == single.state_hash());
    CHECK(many.time() == single.time());
  }
}
