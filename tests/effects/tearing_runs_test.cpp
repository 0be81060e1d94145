#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <memory>
#include <stdexcept>
#include <vector>

#include <hooke/hooke.h>

#include "collide/local_shape.h"
#include "effects/solid_meshes.h"
#include "effects/tearing_scenes.h"
#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

template <class Real>
void check_same_state(const Simulation<Real>& a, const Simulation<Real>& b) {
  CHECK(a.particle_count() == b.particle_count());
  CHECK(a.spring_count() == b.spring_count());
  CHECK(std::ranges::equal(a.triangles(), b.triangles()));
  CHECK(a.state_hash() == b.state_hash());
  CHECK(a.energy().total() == b.energy().total());
}

}  // namespace

TEST_CASE("tearing: the same bits on any number of threads, gathered and coloured") {
  const Scene scene = pulled_cloth().scene;
  for (const Accumulation accumulation : {Accumulation::gather, Accumulation::coloured}) {
    Simulation<float> one(scene, {.step = 5e-3, .accumulation = accumulation, .threads = 1});
    REQUIRE(one.step(120).particles_split > 0);
    for (const unsigned threads : {2u, 4u}) {
      Simulation<float> more(scene, {.step = 5e-3, .accumulation = accumulation, .threads = threads});
      REQUIRE(more.step(120).ok());
      check_same_state(one, more);
    }
  }
}

TEST_CASE("tearing: by every method, and snapshots from before and after tears go on with the same bits") {
  const Scene scene = pulled_cloth(7).scene;
  for (const Method& method : all_methods) {
    CAPTURE(to_string(method));
    const Settings settings{.method = method, .step = 5e-3};
    Simulation<double> whole(scene, settings), restored(scene, settings), torn(scene, settings);
    const Snapshot<double> start = whole.snapshot();
    CHECK_FALSE(start.torn);
    Report report;
    while (report.particles_split == 0 && whole.steps() < 200) report = whole.step();
    REQUIRE(report.particles_split > 0);
    const Snapshot<double> middle = whole.snapshot();
    REQUIRE(middle.torn);
    REQUIRE(whole.step(15).ok());
    CHECK(whole.particle_count() > middle.positions.size() / 3);
    restored.restore(middle);
    REQUIRE(restored.step(15).ok());
    check_same_state(whole, restored);
    restored.restore(start);
    CHECK(restored.particle_count() == scene.particles.size());
    REQUIRE(restored.step(middle.step).ok());
    CHECK(restored.snapshot().positions == middle.positions);
    torn.restore(whole.snapshot());
    check_same_state(whole, torn);
    restored.restore(middle);
    CHECK(restored.snapshot().relaxing == middle.relaxing);
    CHECK(restored.origin(Index(scene.particles.size())) == middle.torn_from[0]);
  }
}

TEST_CASE("tearing: a scene that does not tear has the same bits as one that cannot") {
  for (const Method& method : {Method(SymplecticEuler{}), Method(Verlet{}), Method(Bdf2{})}) {
    CAPTURE(to_string(method));
    Scene with = hung_cloth(12, 9), without = with;
    with.effects.push_back(Tearing{.strain = 100.0, .force = 1e9});
    const Settings settings{.method = method, .step = 1e-2};
    Simulation<float> a(with, settings), b(without, settings);
    const Report torn = a.step(50), whole = b.step(50);
    REQUIRE(torn.ok());
    CHECK(torn.steps_taken == 50);
    CHECK(torn.force_evaluations == whole.force_evaluations);
    CHECK(torn.step == whole.step);
    CHECK(a.state_hash() == b.state_hash());
    CHECK(a.snapshot().torn == nullptr);
    CHECK(b.triangles().empty());
    CHECK(b.origin(3) == 3);
    // Nothing of it is in a plan that does not name it.
    CHECK(a.plan().stages.size() == b.plan().stages.size() + 1);
  }
}

TEST_CASE("tearing: new particles are like others to who asks from outside") {
  Simulation<float> cloth(pulled_cloth().scene, {.step = 5e-3});
  while (cloth.step().particles_split == 0) REQUIRE(cloth.steps() < 200);
  const Index added = Index(cloth.particle_count() - 1);
  std::vector<float> before(3 * cloth.particle_count()), now = before;
  cloth.copy_positions(before.data(), 3 * sizeof(float), 0.0);
  cloth.copy_positions(now.data(), 3 * sizeof(float), 1.0);
  CHECK(before != now);
  for (std::size_t k = 0; k < 3; ++k) CHECK(before[3 * added + k] == before[3 * cloth.origin(added) + k]);
  const Vec3 speed = velocity(cloth, added);
  cloth.apply_impulse(added, {0, 0, 0.01});
  CHECK(velocity(cloth, added).z() > speed.z());
  CHECK_NOTHROW(cloth.stability());
  REQUIRE(cloth.step(20).ok());
  // Nothing is left between a tear and who restores one that is none.
  Snapshot<float> wrong = cloth.snapshot();
  wrong.torn_from.pop_back();
  const std::uint64_t hash = cloth.state_hash();
  CHECK_THROWS_AS(cloth.restore(wrong), std::invalid_argument);
  wrong = cloth.snapshot();
  wrong.torn_from[0] = 1000;
  CHECK_THROWS_AS(cloth.restore(wrong), std::invalid_argument);
  wrong = cloth.snapshot();
  wrong.relaxing = {{100000, 1.0}};
  CHECK_THROWS_AS(cloth.restore(wrong), std::invalid_argument);
  wrong = cloth.snapshot();
  auto broken = std::make_shared<Scene>(*wrong.torn);
  broken->springs.first[0] = 5000;
  wrong.torn = broken;
  CHECK_THROWS_AS(cloth.restore(wrong), std::invalid_argument);
  wrong = cloth.snapshot();
  wrong.positions.pop_back();
  CHECK_THROWS_AS(cloth.restore(wrong), std::invalid_argument);
  CHECK(cloth.state_hash() == hash);
  Scene whole = pulled_cloth().scene;
  whole.effects = {};
  Simulation<float> other(whole, {.step = 5e-3});
  CHECK_THROWS_AS(other.restore(cloth.snapshot()), std::invalid_argument);
}

TEST_CASE("tearing: a run whose steps are not to be divided goes on where lighter particles need it") {
  const Scene scene = pulled_cloth().scene;
  const double longest = largest_stable_step(scene, SymplecticEuler{});
  const Settings settings{.step = 0.99 * longest, .unstable_step = UnstableStep::refuse};
  Simulation<double> simulation(scene, settings);
  const Snapshot<double> start = simulation.snapshot();
  REQUIRE(tear_apart(simulation, 2000));
  CHECK(simulation.settings().unstable_step == UnstableStep::divide);
  simulation.restore(start);
  CHECK(simulation.settings().unstable_step == UnstableStep::refuse);
}

TEST_CASE("tearing: a mesh is prepared once for what has the same reach, and seen by each apart") {
  using Shape = LookedUpShape<MeshDistance<float>>;
  const ColliderShape mesh = box_mesh({0.5, 0.3, 0.7});
  PreparedMeshes meshes, others;
  const auto shape = [&](double reach, PreparedMeshes& from) {
    return std::get<Shape>(local_shape<float>(mesh, reach, 1, from));
  };
  const Shape first = shape(0.1, meshes), second = shape(0.1, meshes);
  CHECK(first.distances == second.distances);
  CHECK(first.seen != second.seen);
  CHECK(first.distances != shape(0.2, meshes).distances);
  CHECK(first.distances != shape(0.1, others).distances);
  CHECK(meshes.size() == 2);
}

TEST_CASE("tearing: the torn scene goes on with the meshes that were prepared for the whole one") {
  PulledCloth cloth = pulled_cloth(4);
  MeshShape mesh = bumpy_mesh(3);
  for (Vec3& vertex : mesh.vertices) vertex.y() -= 5.0;
  cloth.scene.effects.push_back(Collider{.shape = mesh, .thickness = 0.01});
  const std::clock_t begun = std::clock();
  Simulation<float> simulation(cloth.scene, {.step = 5e-3, .threads = 1});
  const std::clock_t made = std::clock();
  REQUIRE(tear_apart(simulation, 200));
  CHECK(double(std::clock() - made) < 0.5 * double(made - begun));
}
