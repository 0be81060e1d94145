#include <doctest/doctest.h>

#include "irregular_mesh.h"
#include "sanitized.h"
#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

Scene irregular_cloth() {
  Scene scene;
  const MeshParticles cloth = add(scene, irregular_mesh(70));
  for (Index particle : furthest_along(scene, cloth.first, cloth.count, Vec3(0, 1, 0), 0.02))
    scene.pin(particle);
  scene.effects = {Gravity{}, Drag{1e-5}, GroundPlane{.height = -0.9, .stiffness = 50.0}};
  return scene;
}

Scene damped_cloth() {
  Scene scene = hung_cloth(70, 75, 0.001);
  scene.effects.push_back(Field{[](const Vec3& x, double t) { return Vec3(0, 0, 1e-4 * x.x() * t); }});
  return scene;
}

constexpr std::uint64_t steps = sanitized ? 8 : 1000;

template <class Real>
std::uint64_t hash_after(const Scene& scene, Accumulation accumulation, unsigned threads) {
  Simulation<Real> simulation(scene, {.step = 2e-4, .accumulation = accumulation, .threads = threads});
  const std::uint64_t before = simulation.state_hash();
  REQUIRE(simulation.step(steps).ok());
  REQUIRE(simulation.state_hash() != before);
  return simulation.state_hash();
}

}  // namespace

TEST_CASE_TEMPLATE("same bits on 1, 2, 3, 4 and 7 threads after 1,000 steps", Real, float, double) {
  for (const Scene& scene : {damped_cloth(), irregular_cloth()}) {
    for (auto accumulation : {Accumulation::gather, Accumulation::coloured}) {
      const std::uint64_t one = hash_after<Real>(scene, accumulation, 1);
      for (unsigned threads : {2u, 3u, 4u, 7u}) CHECK(hash_after<Real>(scene, accumulation, threads) == one);
    }
  }
}

TEST_CASE("every method gives the same bits on 1 and 3 threads, in both modes that can be reproduced") {
  const Scene scene = irregular_cloth();
  for (const Method& method : all_methods) {
    for (auto accumulation : {Accumulation::gather, Accumulation::coloured}) {
      CAPTURE(to_string(method));
      if (!can_accumulate(method, accumulation)) continue;
      const auto hash = [&](unsigned threads) {
        Simulation<float> simulation(
            scene, {.method = method, .step = 1e-4, .accumulation = accumulation, .threads = threads});
        REQUIRE(simulation.step(sanitized ? 3 : 10).ok());
        return simulation.state_hash();
      };
      CHECK(hash(1) == hash(3));
    }
  }
}

TEST_CASE("energy, momentum and strain are the same bits on any number of threads") {
  const Scene scene = damped_cloth();
  Simulation<float> one(scene, {.step = 2e-4, .threads = 1}), seven(scene, {.step = 2e-4, .threads = 7});
  REQUIRE(one.step(50).ok());
  REQUIRE(seven.step(50).ok());
  CHECK(one.energy().total() == seven.energy().total());
  CHECK(one.momentum() == seven.momentum());
  CHECK(one.max_strain() == seven.max_strain());
}

TEST_CASE("the hash sees a change of one bit") {
  const Scene scene = hung_cloth(5, 5);
  Simulation<float> simulation(scene, {.step = 1e-3});
  Snapshot<float> snapshot = simulation.snapshot();
  const std::uint64_t before = simulation.state_hash();
  snapshot.velocities[74] = std::nextafter(snapshot.velocities[74], 1.0f);
  simulation.restore(snapshot);
  CHECK(simulation.state_hash() != before);
}
