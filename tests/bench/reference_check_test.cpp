#include "reference_check.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>

#include "bench_scenes.h"

using namespace hooke;
using bench::BenchScene;
using bench::ReferenceCheck;

namespace {

template <class Real>
Simulation<Real> simulation_of(const BenchScene& scene, Accumulation accumulation = Accumulation::gather) {
  return Simulation<Real>(
      scene.scene,
      {.step = scene.step, .unstable_step = UnstableStep::take, .accumulation = accumulation, .threads = 2});
}

template <class Real>
void check_that_errors_are_seen(BenchScene scene) {
  const ReferenceCheck check(scene);
  auto good = simulation_of<Real>(scene);
  const auto hash = good.state_hash();
  CHECK(check.distance(good) < ReferenceCheck::tolerance<Real>);
  CHECK(good.state_hash() == hash);  // it is left as it was

  BenchScene wrong = scene;
  auto& stiffness = wrong.scene.springs.stiffness;  // lost: a stretch spring, as far as can be from a pin
  *std::find(stiffness.begin() + std::ptrdiff_t(stiffness.size() / 2), stiffness.end(), 100.0) = 0.0;
  auto one_spring_lost = simulation_of<Real>(wrong);
  CHECK(check.distance(one_spring_lost) > 3.0 * ReferenceCheck::tolerance<Real>);

  wrong = scene;
  wrong.step *= 1.05;
  auto longer_steps = simulation_of<Real>(wrong);
  CHECK(check.distance(longer_steps) > 3.0 * ReferenceCheck::tolerance<Real>);
}

}  // namespace

TEST_CASE("the check passes good runs and sees one lost spring, or another step, among many") {
  for (const BenchScene& scene :
       {bench::cloth(16), bench::cloth(256), bench::jittered_cloth("jittered", 100, 100)}) {
    CAPTURE(scene.name);
    check_that_errors_are_seen<float>(scene);
    check_that_errors_are_seen<double>(scene);
  }
}

TEST_CASE("a run that gained energy, or went bad, did not stay good") {
  BenchScene scene = bench::cloth(16);
  const ReferenceCheck check(scene);
  auto simulation = simulation_of<double>(scene);
  const double energy = simulation.energy().total();
  CHECK(check.stayed_good(simulation, simulation.step(100), energy));
  CHECK_FALSE(check.stayed_good(simulation, simulation.step(), energy - 1e-3));

  scene.step *= 100.0;
  auto unstable = simulation_of<double>(scene);
  const double before = unstable.energy().total();
  CHECK_FALSE(check.stayed_good(unstable, unstable.step(100'000), before));
}

TEST_CASE("round-off of a fine irregular mesh, in its first steps from rest, is not taken for a fault") {
  BenchScene scene = bench::jittered_cloth("jittered", 400, 250);
  const ReferenceCheck check(scene);
  auto simulation = simulation_of<float>(scene);
  const double energy = simulation.energy().total();
  for (int i = 0; i < 20; ++i) CHECK(check.stayed_good(simulation, simulation.step(), energy));
}
