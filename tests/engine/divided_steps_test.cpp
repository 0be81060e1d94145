#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "irregular_mesh.h"
#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double frame = 1.0 / 60.0;

/// With springs of the irregular kind and of the grid's, damped.
Scene stiff_cloth() {
  Scene scene = hung_cloth(12, 10, 0.001);
  add(scene, irregular_mesh(10));
  for (double& k : scene.springs.stiffness) k *= 40.0;
  return scene;
}

template <class Real>
std::vector<Real> positions(const Simulation<Real>& simulation, double interpolation = 1.0) {
  std::vector<Real> result(3 * simulation.particle_count());
  simulation.copy_positions(result.data(), 3 * sizeof(Real), interpolation);
  return result;
}

std::vector<Method> dividing_methods() {
  return {SymplecticEuler{}, Verlet{}, RungeKutta4{}, BlanesMoan{}};
}

}  // namespace

TEST_CASE("a step that is too long is taken in equal parts, with the bits of shorter steps") {
  const Scene scene = stiff_cloth();
  for (const Method& method : dividing_methods()) {
    for (auto accumulation : {Accumulation::gather, Accumulation::coloured}) {
      CAPTURE(to_string(method));
      Simulation<float> divided(scene, {.method = method, .step = frame, .accumulation = accumulation});
      const std::uint64_t substeps = divided.plan().substeps;
      REQUIRE(substeps == std::uint64_t(std::ceil(frame / (0.9 * largest_stable_step(scene, method)))));
      REQUIRE(substeps > 3);
      Simulation<float> fine(
          scene,
          {.method = method, .step = frame / double(substeps), .accumulation = accumulation, .threads = 1});
      REQUIRE(fine.plan().substeps == 1);
      const Report report = divided.step(9);
      REQUIRE(report.ok());
      CHECK(report.steps_taken == 9);
      REQUIRE(fine.step(9 * substeps).ok());
      CHECK(report.force_evaluations ==
            9 * substeps * std::visit([](const auto& one) { return one.force_evaluations; }, method));
      CHECK(divided.time() == 9 * frame);
      CHECK(divided.snapshot().velocities == fine.snapshot().velocities);
      CHECK(positions(divided) == positions(fine));
    }
  }
}

TEST_CASE("the state before the newest is a whole step behind, however many are taken at once") {
  const Scene scene = stiff_cloth();
  for (auto accumulation : accumulations) {
    for (std::uint64_t count : {1u, 2u, 7u, 40u}) {
      const Settings settings{.step = 0.1 * frame, .accumulation = accumulation, .threads = 1};
      Simulation<float> simulation(scene, settings), before(scene, settings);
      REQUIRE(simulation.plan().substeps > 1);
      REQUIRE(simulation.step(count).ok());
      REQUIRE(before.step(count - 1).ok());
      CHECK(positions(simulation, 0.0) == positions(before));
    }
  }
}

TEST_CASE("a divided run goes on from a snapshot with the same bits") {
  const Scene scene = stiff_cloth();
  for (const Method& method : dividing_methods()) {
    const Settings settings{.method = method, .step = frame};
    Simulation<double> whole(scene, settings), restored(scene, settings);
    REQUIRE(whole.step(5).ok());
    restored.restore(whole.snapshot());
    REQUIRE(whole.step(5).ok());
    REQUIRE(restored.step(5).ok());
    CHECK(restored.state_hash() == whole.state_hash());
  }
}

TEST_CASE("a divided step that goes bad is not taken, and the first bad particle is named") {
  Scene scene = stiff_cloth();
  scene.effects.push_back(
      Field{[](const Vec3& x, double t) { return Vec3(0, t > 5.5 * frame && x.x() > 0.1 ? NAN : 0.0, 0); }});
  Index expected = 0;
  while (scene.particles.position[expected].x() <= 0.11) ++expected;
  for (auto accumulation : accumulations) {
    Simulation<float> simulation(scene, {.step = frame, .accumulation = accumulation});
    REQUIRE(simulation.plan().substeps > 1);
    const Report report = simulation.step(20);
    CHECK_FALSE(report.ok());
    CHECK(report.steps_taken == 5);
    CHECK(report.step == 6);
    CHECK(simulation.time() == 5 * frame);
    CHECK(report.first_bad_particle <= expected);
    Simulation<float> good(scene, {.step = frame, .accumulation = accumulation});
    REQUIRE(good.step(5).ok());
    if (accumulation != Accumulation::atomic) CHECK(positions(good) == positions(simulation));
  }
}

TEST_CASE("a step that a method bears is taken whole, and so is one that no shortening would help") {
  CHECK(Simulation<float>(hung_cloth(8, 8), {.step = 1e-3}).plan().substeps == 1);
  CHECK(Simulation<float>(one_particle(), {.step = 1e3}).plan().substeps == 1);
  CHECK(Simulation<float>(stiff_cloth(), {.method = ExplicitEuler{}, .step = frame}).plan().substeps == 1);
  CHECK(Simulation<float>(stiff_cloth(), {.method = DormandPrince{1e-3}, .step = frame}).plan().substeps ==
        1);
}

TEST_CASE("who asks for it has long steps refused, or taken") {
  const Scene scene = stiff_cloth();
  const Settings refusing{.step = frame, .unstable_step = UnstableStep::refuse};
  const std::vector<Fault> faults = validate(scene, refusing);
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].problem.find("symplectic_euler surely bears only") != std::string::npos);
  CHECK(faults[0].remedy.find("divide") != std::string::npos);
  CHECK_THROWS_AS(Simulation<float>(scene, refusing), SceneError);
  CHECK(validate(scene, {.step = largest_stable_step(scene, SymplecticEuler{}),
                         .unstable_step = UnstableStep::refuse})
            .empty());
  const std::vector<Fault> hopeless =
      validate(scene, {.method = ExplicitEuler{}, .unstable_step = UnstableStep::refuse});
  REQUIRE(hopeless.size() == 1);
  CHECK(hopeless[0].remedy.find("symplectic_euler") != std::string::npos);
  Simulation<float> taking(scene, {.step = frame, .unstable_step = UnstableStep::take});
  CHECK(taking.plan().substeps == 1);
  CHECK_FALSE(taking.step(1000).ok());
}

TEST_CASE("a step that would need more than a hundred thousand parts is refused") {
  Scene scene = hung_cloth(4, 4);
  scene.springs.stiffness[3] = 1e15;
  const std::vector<Fault> faults = validate(scene, Settings{.step = frame});
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].message().find("softer springs") != std::string::npos);
  scene.springs.stiffness[3] = 1e308;
  CHECK(validate(scene, Settings{.step = frame}).size() == 1);
}
