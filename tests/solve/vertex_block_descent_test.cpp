#include "solve/vertex_block_descent.h"
#include "sanitized.h"

#include <doctest/doctest.h>

#include "irregular_mesh.h"
#include "solve/hard_scenes.h"
#include "solve/solver_run.h"

using namespace hooke;
using namespace hooke::test;

namespace {

template <class Real>
using Run = SolverRun<Real, VertexBlockDescent>;

constexpr VertexBlockDescent to_the_end{.iterations = 50'000, .tolerance = 1e-14};

Scene irregular_cloth() {
  Scene scene;
  const MeshParticles cloth = add(scene, irregular_mesh(30));
  for (Index particle : furthest_along(scene, cloth.first, cloth.count, Vec3(0, 1, 0), 0.05))
    scene.pin(particle);
  scene.effects = {Gravity{}, Drag{1e-4}, GroundPlane{.height = -0.9, .stiffness = 50.0}};
  return scene;
}

/// The largest force at rest or in the first step, to compare errors with.
double weight(const Scene& scene) {
  double mass = 0.0;
  for (const double one : scene.particles.mass) mass += one;
  return 9.81 * mass;
}

}  // namespace

TEST_CASE("descent to the end solves the equations of backward Euler, pressed and stretched, with damping") {
  for (const double factor : {0.5, 1.0, 1.3}) {
    for (const double damping : {0.0, 0.01}) {
      CAPTURE(factor);
      CAPTURE(damping);
      const Scene scene = disturbed_cloth(factor, 0.3, damping);
      Run<double> run(scene, to_the_end);
      for (int step = 0; step < 3; ++step) {
        const StageResult result = run.step(1.0 / 60.0);
        CHECK(result.converged);
        CHECK(run.lacking_force() < 1e-8 * weight(scene));
      }
    }
  }
}

TEST_CASE("so it does on meshes without a regular numbering, on the ground, and in random networks") {
  const Scene mesh = irregular_cloth();
  Run<double> run(mesh, to_the_end);
  for (int step = 0; step < 5; ++step) run.step(1.0 / 60.0);
  CHECK(run.lacking_force() < 1e-8 * weight(mesh));
  for (std::uint32_t seed = 0; seed < (sanitized ? 4u : 40u); ++seed) {
    CAPTURE(seed);
    const Scene network = RandomNetwork(seed).make();
    Run<double> of_network(network, to_the_end);
    const StageResult result = of_network.step(0.02);
    CHECK(result.converged);
    CHECK(of_network.lacking_force() < 1e-8 * weight(network));
  }
}

TEST_CASE("descent to the end takes the same step as Newton's method to the end, to 1e-8") {
  double worst = 0.0;
  const auto compare = [&](const Scene& scene, double h) {
    Run<double> descent(scene, to_the_end);
    SolverRun<double, Method> newton(scene, BackwardEuler{.tolerance = 1e-13, .most_iterations = 1000});
    CHECK(descent.step(h).converged);
    CHECK(newton.step(h).converged);
    for (Index i = 0; i < scene.particles.size(); ++i)
      worst = std::max(worst, (descent.position(i) - newton.position(i)).norm());
  };
  for (const double damping : {0.0, 0.01}) {
    // Pressed springs may give way to more than one side: where steps are short there is one solution.
    for (const double factor : {0.6, 1.0, 1.3}) compare(disturbed_cloth(factor, 0.2, damping), 1e-3);
    Scene taut = disturbed_cloth(1.0, 0.2, damping);
    for (Index i = 0; i < taut.particles.size(); ++i) {
      const bool rim = i % 17 == 0 || i % 17 == 16 || i / 17 == 0 || i / 17 == 12;
      if (rim && i != 0 && i != 16) taut.pin(i);
    }
    for (double& length : taut.springs.rest_length) length *= 0.5;
    compare(taut, 1.0 / 60.0);
  }
  MESSAGE("largest difference of a position: ", worst, " m");
  CHECK(worst < 1e-8 * 0.4);  // of the cloth's size
}

TEST_CASE_TEMPLATE("nothing degenerate makes values that are not finite", Real, float, double) {
  for (const auto& [what, scene] : degenerate_scenes()) {
    for (const double acceleration : {0.0, 0.95}) {
      CAPTURE(what);
      Run<Real> run(scene, VertexBlockDescent{.acceleration = acceleration});
      const State<Real> before = run.now;
      for (int step = 0; step < 20; ++step) run.step(1.0 / 60.0);
      CHECK(run.finite());
      for (std::size_t i = 0; i < run.now.size(); ++i) {
        if (run.model.pinned(i)) CHECK(run.now.position(i) == before.position(i));
      }
    }
  }
}

TEST_CASE("a particle alone falls as by backward Euler, in one sweep") {
  Scene scene = one_particle();
  scene.particles.velocity = {Vec3(1, 2, 3)};
  scene.effects = {Gravity{.acceleration = Vec3(0, -10, 0)}, Drag{.coefficient = 2.0}};
  Run<double> run(scene, VertexBlockDescent{.iterations = 1});
  run.step(0.5);  // v' = (v + h g) / (1 + h c / m)
  CHECK((run.velocity(0) - Vec3(0.5, -1.5, 1.5)).norm() < 1e-15);
  CHECK((run.position(0) - Vec3(0.25, -0.75, 0.75)).norm() < 1e-15);
}

TEST_CASE("particles that no spring joins keep their velocity exactly") {
  Scene scene;
  for (Index i = 0; i < 50; ++i) scene.add_particle(0.1 + i, Vec3(i, 0, 0), Vec3(1, 0.5, -0.25));
  Run<double> run(scene, VertexBlockDescent{});
  for (int step = 0; step < 64; ++step) run.step(0.25);
  for (Index i = 0; i < 50; ++i) {
    CHECK(run.velocity(i) == Vec3(1, 0.5, -0.25));
    CHECK(run.position(i) == Vec3(i + 16.0, 8.0, -4.0));
  }
}

TEST_CASE("acceleration takes fewer sweeps to the same step") {
  const Scene scene = disturbed_cloth(1.0, 0.2);
  const auto sweeps = [&](double acceleration, State<double>& end) {
    Run<double> run(scene,
                    VertexBlockDescent{.iterations = 5000, .tolerance = 1e-12, .acceleration = acceleration});
    const StageResult result = run.step(1.0 / 30.0);
    CHECK(result.converged);
    end = run.now;
    return result.iterations;
  };
  State<double> plain(0), fast(0);
  const std::uint64_t without = sweeps(0.0, plain), with = sweeps(0.9, fast);
  MESSAGE("sweeps without acceleration ", without, ", with it ", with);
  CHECK(with < 3 * without / 4);
  double apart = 0.0;
  for (std::size_t i = 0; i < plain.size(); ++i)
    apart = std::max(apart, (plain.position(i) - fast.position(i)).norm());
  CHECK(apart < 1e-9);
}

TEST_CASE("too much acceleration is given up, and the step still found") {
  const Scene scene = disturbed_cloth(0.5, 0.4);
  Run<double> run(scene,
                  VertexBlockDescent{.iterations = 20'000, .tolerance = 1e-12, .acceleration = 0.9999});
  const StageResult result = run.step(1.0 / 60.0);
  CHECK(result.converged);
  CHECK(run.lacking_force() < 1e-7 * weight(scene));
}

TEST_CASE("a cloth thrown into a heap comes to rest: no step is too long, no state too wild") {
  Scene scene = hung_cloth(12, 12);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (Vec3& position : scene.particles.position)
    position = 0.22 * Vec3(unit(random), unit(random), unit(random));
  for (const double h : {1.0 / 60.0, 1.0, 10.0}) {
    CAPTURE(h);
    Run<double> run(scene, VertexBlockDescent{.iterations = 30});
    for (int step = 0; step < 200; ++step) run.step(h);
    CHECK(run.finite());
    double fastest = 0.0, furthest = 0.0;
    for (Index i = 0; i < scene.particles.size(); ++i) {
      fastest = std::max(fastest, run.velocity(i).norm());
      furthest = std::max(furthest, run.position(i).norm());
    }
    CHECK(furthest < 2.0);
    CHECK(fastest < 5.0);
  }
}
