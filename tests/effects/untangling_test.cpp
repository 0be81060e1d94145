#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include <hooke/hooke.h>

#include "collide/crossings.h"
#include "collide/intersection_curves.h"
#include "effects/crossings.h"
#include "effects/sphere_scene.h"
#include "fine_executor.h"
#include "scenes.h"
#include "scenes/hard/tangles.h"

using namespace hooke;
using namespace hooke::hard;
using namespace hooke::test;

namespace {

const Settings frames{.method = BackwardEuler{}, .step = 1.0 / 60.0, .threads = 1};

/// Two balls that overlap.
Scene two_balls() {
  Scene scene;
  for (const double side : {-1.0, 1.0}) {
    const Scene ball = sphere_scene(3, 0.2, 0.0);
    ClothMesh mesh;
    mesh.areal_density = 2.0, mesh.stretch = 100.0, mesh.bend = 1.0;
    mesh.triangles = ball.triangles;
    for (const Vec3& x : ball.particles.position)
      mesh.vertices.push_back(x + Vec3(0.16, 0.003, 0.0017) * side);
    add(scene, mesh);
  }
  untangle(scene);
  return scene;
}

/// The crossings at the start and after each frame, until there are none or the frames are over.
std::vector<std::uint64_t> crossings_of_frames(const Scene& scene, const Settings& settings, int most) {
  Simulation<double> simulation(scene, settings);
  std::vector<std::uint64_t> crossings;
  for (int i = 0; i < most && (crossings.empty() || crossings.back() > 0); ++i) {
    const Report report = simulation.step();
    REQUIRE(report.ok());
    crossings.push_back(report.crossings);
  }
  CHECK((count_crossings(simulation, scene) == 0) == (crossings.back() == 0));
  return crossings;
}

struct Traced {
  std::size_t curves = 0, crossings = 0, cut_off = 0;  ///< the last: crossings with an end in a region
};

Traced trace(const Scene& scene) {
  const Surface surface(scene.triangles);
  const auto executor = make_tbb_executor(1);
  ClosePairs near(surface, scene.particles.position, 1e-3);
  near.find(scene.particles.position, scene.particles.position, 0.0, *executor);
  Crossings crossings(surface);
  crossings.look(near.edge_boxes(), near.triangle_boxes(), &scene.particles.position, 0.0, *executor);
  const std::vector<Crossing>& found = crossings.find(scene.particles.position, *executor);
  IntersectionCurves curves(surface);
  std::set<Index> numbers;
  Traced traced;
  for (const auto& place : curves.trace(found, scene.particles.position)) {
    numbers.insert(place.curve);
    traced.cut_off += place.inside != ~Index{0} ? 1 : 0;
  }
  traced.crossings = found.size();
  traced.curves = numbers.size();
  return traced;
}

/// Each edge once with each triangle that it goes through, by looking at all.
std::size_t count_by_looking_at_all(const Scene& scene) {
  const std::vector<Vec3>& x = scene.particles.position;
  const Surface surface(scene.triangles);
  std::size_t crossings = 0;
  for (const auto& [p, q] : surface.edges) {
    for (const auto& [a, b, c] : surface.triangles) {
      const bool is_joined = p == a || p == b || p == c || q == a || q == b || q == c;
      crossings += !is_joined && crosses(x[p], x[q], x[a], x[b], x[c]) ? 1 : 0;
    }
  }
  return crossings;
}

}  // namespace

TEST_CASE("untangling: crossings are found, and traced into the curves that they lie on") {
  CHECK(trace(bbii_tangle()).crossings == count_by_looking_at_all(bbii_tangle()));
  for (const Scene& closed : {closed_tangle(), two_balls(), eight_tangle()}) {
    const Traced traced = trace(closed);
    CHECK(traced.curves == 1);
    CHECK(traced.cut_off == traced.crossings);
  }
  const Traced bbii = trace(bbii_tangle()), bibi = trace(bibi_tangle()), ll = trace(ll_tangle()),
               bli = trace(bli_tangle());
  CHECK(bbii.curves == 1);
  CHECK(bbii.cut_off > 0);
  CHECK(bbii.cut_off < bbii.crossings);  // the slit in the wide sheet cuts nothing off
  CHECK(bibi.curves == 1);
  CHECK(bibi.cut_off == 0);
  CHECK(ll.curves == 1);
  CHECK(ll.cut_off + 2 >= ll.crossings);  // all but edges at the corners that it ends in
  CHECK(bli.curves == 1);
  CHECK(bli.cut_off == 0);
}

TEST_CASE("untangling: what crosses in a closed curve gets ever fewer crossings, and none within 60 frames") {
  for (const Method& method : {Method(BackwardEuler{}), Method(Xpbd{})}) {
    for (const Scene& scene : {closed_tangle(), two_balls(), eight_tangle()}) {
      Settings settings = frames;
      settings.method = method;
      const auto crossings = crossings_of_frames(scene, settings, 60);
      CHECK(crossings.front() > 50);
      CHECK(crossings.back() == 0);
      CHECK(std::is_sorted(crossings.rbegin(), crossings.rend()));
    }
  }
}

/// The others of this kind are in hard case 31: they take longer.
TEST_CASE("untangling: what crosses in an open curve or a small loop is free within 60 frames") {
  Settings fast = frames;
  fast.method = Xpbd{};
  for (const Scene& scene : {bbii_tangle(), bibi_tangle()})
    CHECK(crossings_of_frames(scene, fast, 60).back() == 0);
  CHECK(crossings_of_frames(ll_tangle(), frames, 60).back() == 0);
}

TEST_CASE("untangling: what cannot be drawn apart is told") {
  const auto crossings = crossings_of_frames(large_loop_tangle(), frames, 5);
  CHECK(crossings.size() == 5);
  CHECK(crossings.back() > 30);
}

TEST_CASE("untangling: cloth that crosses nothing has the same bits with and without it") {
  Scene without;
  add_shaped_sheet(without, 12, 12, level_sheet(0.18));
  add_shaped_sheet(without, 8, 8, [](double u, double v) { return Vec3(0.1 * u, 0.03 + 0.01 * u, 0.1 * v); });
  for (Index i = 0; i < 144; ++i) without.pin(i);
  untangle(without);
  without.effects.push_back(Gravity{});
  auto& collision = std::get<SelfCollision>(without.effects.front());
  collision.friction = 0.3;
  for (const bool swept : {true, false}) {
    collision.swept = swept;
    Scene with = without;
    collision.untangle = false;
    Simulation<float> a(without, {.method = BackwardEuler{}, .step = 2e-3}),
        b(with, {.method = BackwardEuler{}, .step = 2e-3});
    for (auto* simulation : {&a, &b}) REQUIRE(simulation->step(80).flags == flag_none);
    CHECK(a.state_hash() == b.state_hash());
    CHECK(position(a, 150).y() > 0.0);  // it has come to lie on the other
    CHECK(position(a, 150).y() < 0.02);
    collision.untangle = true;
  }
}

TEST_CASE_TEMPLATE("untangling: the same bits on 1, 2 and 5 threads", Real, float, double) {
  const Scene scene = two_balls();
  std::vector<std::uint64_t> hashes;
  for (const unsigned threads : {1u, 2u, 5u}) {
    Simulation<Real> simulation(
        scene,
        {.method = BackwardEuler{}, .step = 1.0 / 60.0, .executor = std::make_shared<FineExecutor>(threads)});
    const Report report = simulation.step(3);
    REQUIRE(report.ok());
    CHECK(report.crossings > 0);
    hashes.push_back(simulation.state_hash());
  }
  CHECK(hashes[1] == hashes[0]);
  CHECK(hashes[2] == hashes[0]);
}

TEST_CASE("untangling: momentum and centre of mass stay, and hardly any motion is left") {
  const Scene scene = two_balls();
  Simulation<double> simulation(scene, {.step = 1e-3, .threads = 1});
  const auto centre = [&] {
    Vec3 sum = Vec3::Zero();
    for (Index i = 0; i < scene.particles.size(); ++i)
      sum += scene.particles.mass[i] * position(simulation, i);
    return sum;
  };
  double mass = 0.0;
  for (const double one : scene.particles.mass) mass += one;
  const Vec3 before = centre();
  for (int i = 0; i < 50; ++i) {
    REQUIRE(simulation.step().flags == flag_none);
    CHECK(simulation.energy().kinetic < 0.5 * mass * 0.2 * 0.2);  // drawn apart at half a metre a second
  }
  CHECK(simulation.momentum().norm() < 1e-12 * mass);
  CHECK((centre() - before).norm() < 1e-6 * mass);
}

TEST_CASE("untangling: all goes by the state alone") {
  const Scene scene = two_balls();
  Simulation<float> straight(scene, frames), restored(scene, frames);
  straight.step(2);
  restored.restore(straight.snapshot());
  straight.step(2);
  restored.step(2);
  CHECK(restored.state_hash() == straight.state_hash());
}

TEST_CASE("untangling: what lies on a collider is not drawn into it") {
  Scene scene = closed_tangle();
  scene.effects.push_back(
      Collider{.shape = PlaneShape{.normal = {0.0, -1.0, 0.0}, .height = -0.062}, .thickness = 0.002});
  Simulation<double> simulation(scene, frames);
  std::uint64_t crossings = 1;
  for (int i = 0; i < 60 && crossings > 0; ++i) {
    crossings = simulation.step().crossings;
    for (Index p = 0; p < scene.particles.size(); ++p) CHECK(position(simulation, p).y() < 0.0601);
  }
  CHECK(crossings == 0);
}

TEST_CASE("untangling: what goes further in at a crossing loses that speed") {
  Scene scene = two_balls();
  scene.particles.velocity.assign(scene.particles.size(), Vec3::Zero());
  const Index half = Index(scene.particles.size() / 2);
  for (Index i = 0; i < scene.particles.size(); ++i)
    scene.particles.velocity[i] = Vec3(i < half ? 1.0 : -1.0, 0.0, 0.0);
  Simulation<double> simulation(scene, frames);
  double energy = simulation.energy().kinetic;
  const double at_first = energy;
  for (int i = 0; i < 3; ++i) {
    REQUIRE(simulation.step().ok());
    CHECK(simulation.energy().kinetic < energy);
    energy = simulation.energy().kinetic;
  }
  CHECK(energy < 0.9 * at_first);
}

TEST_CASE("untangling: pinned cloth is not moved, and what is in it comes out") {
  Scene scene = closed_tangle();
  for (Index i = 0; i < 24 * 24; ++i) scene.pin(i);
  Simulation<double> simulation(scene, frames);
  std::uint64_t crossings = 1;
  for (int i = 0; i < 60 && crossings > 0; ++i) crossings = simulation.step().crossings;
  CHECK(crossings == 0);
  for (Index i = 0; i < 24 * 24; ++i) CHECK(position(simulation, i) == scene.particles.position[i]);
}
