// Spring forces of whole numbers: then every sum is exact in whatever order, and one addition that is lost,
// doubled or made to the wrong particle shows in the bits.

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "fine_executor.h"
#include "forces.h"
#include "irregular_mesh.h"
#include "sanitized.h"
#include "scenes.h"

using namespace hooke;

namespace {

// Additions are lost only now and then.
constexpr int rounds = test::sanitized ? 3 : 50;

/// The same network with springs of no rest length and no damping, and whole positions and stiffnesses.
Scene in_whole_numbers(Scene scene) {
  std::mt19937 random(1);
  const auto whole = [&](int low, int high) {
    return double(low + int(random() % unsigned(high - low + 1)));
  };
  for (Vec3& x : scene.particles.position) x = Vec3(whole(-8, 8), whole(-8, 8), whole(-8, 8));
  for (double& k : scene.springs.stiffness) k = whole(1, 4);
  for (double& length : scene.springs.rest_length) length = 0.0;
  scene.springs.damping.clear();
  scene.pins.clear();
  scene.effects.clear();
  return scene;
}

std::vector<Vec3> plain_sums(const Scene& scene) {
  std::vector<Vec3> sums(scene.particles.size(), Vec3::Zero());
  for (std::size_t s = 0; s < scene.springs.size(); ++s) {
    const Index a = scene.springs.first[s], b = scene.springs.second[s];
    const Vec3 force =
        scene.springs.stiffness[s] * (scene.particles.position[b] - scene.particles.position[a]);
    sums[a] += force;
    sums[b] -= force;
  }
  return sums;
}

/// The model with its springs in batches of so many blocks, and its particles in the order given.
template <class Real>
Model<Real> model_in_batches(const Scene& scene, const Order& order, Accumulation accumulation,
                             std::size_t batch_blocks, Executor& executor) {
  Model<Real> model(scene, accumulation, executor);
  model.order = order;
  const Adjacency adjacency(scene.springs, scene.particles.size());
  Slots<Real> slots = make_slots<Real>(scene.springs, adjacency, order, executor, SpringEnds::one);
  model.spring_layout = accumulation == Accumulation::coloured
                            ? colour_batches(std::move(slots), batch_blocks)
                            : share_batches(std::move(slots), batch_blocks);
  return model;
}

/// Particles on which the forces differ from the plain sums, over several rounds.
template <class Real>
int wrong_particles(const Scene& scene, const Model<Real>& model, Executor& executor) {
  const std::vector<Vec3> expected = plain_sums(scene);
  const State<Real> state = initial_state(scene, model);
  Forces<Real> forces(scene, model);
  int wrong = 0;
  for (int round = 0; round < rounds; ++round) {
    forces.prepare(state, state.time, executor);
    for_each_strip(0, block_count(state.size()), [&](std::size_t begin, std::size_t end) {
      const Strip<Real> strip(state, begin, end);
      StripForce<Real> force;
      forces.on_strip(strip, state, 0.0, force);
      for (std::size_t lane = 0; lane < strip.particles; ++lane) {
        const Vec3 found(force.x[lane], force.y[lane], force.z[lane]);
        wrong += found != expected[model.order.user(strip.first + lane)];
      }
    });
  }
  return wrong;
}

template <class Real>
void check_scattered(Scene scene) {
  scene = in_whole_numbers(std::move(scene));
  const std::size_t particles = scene.particles.size();
  if (scene.springs.size() == 0) return;
  test::FineExecutor three(3);
  const auto one = make_tbb_executor(1);
  for (const Order& order :
       {Order(particles, ""), choose_order(scene.springs, Adjacency(scene.springs, particles), particles)}) {
    for (auto accumulation : {Accumulation::coloured, Accumulation::atomic}) {
      for (std::size_t batch_blocks : {1u, 3u, 64u}) {
        const auto model = model_in_batches<Real>(scene, order, accumulation, batch_blocks, three);
        CHECK(wrong_particles(scene, model, three) == 0);
        CHECK(wrong_particles(scene, model, *one) == 0);
      }
    }
  }
}

/// Particles 0 to 15 all joined to one far away, and to one another so that there is more to add.
Scene many_lanes_one_neighbour() {
  Scene scene;
  for (int i = 0; i < 70; ++i) scene.add_particle(1.0, Vec3::Zero());
  for (Index i = 0; i < 16; ++i) {
    scene.add_spring(i, 40, 1.0, 0.0);
    scene.add_spring(i, 20 + i * i % 50, 1.0, 0.0);
  }
  return scene;
}

}  // namespace

TEST_CASE_TEMPLATE("scattered forces are those of a plain loop, bit for bit, in batches of any length", Real,
                   float, double) {
  for (std::uint32_t seed = 0; seed < 15; ++seed) check_scattered<Real>(test::RandomNetwork(seed).make());
  check_scattered<Real>(test::hung_cloth(45, 37));
  check_scattered<Real>(test::hung_cloth(64, 20));
  Scene mesh;
  add(mesh, test::irregular_mesh(40));
  check_scattered<Real>(mesh);
}

TEST_CASE_TEMPLATE("one particle is the neighbour in all lanes of a slot", Real, float, double) {
  const Scene scene = in_whole_numbers(many_lanes_one_neighbour());
  const auto executor = make_tbb_executor(1);
  const auto model = model_in_batches<Real>(scene, Order(70, ""), Accumulation::coloured, 1, *executor);
  const Slots<Real>& slots = *slots_of(model);
  const auto& list = slots.list(0);
  int most_alike = 0;
  for (std::uint32_t s = list.first_indexed; s < list.end; ++s) {
    int alike = 0;
    for (std::size_t lane = 0; lane < block_size; ++lane)
      alike += slots.neighbour(0, slots.slots[s], lane) == 40;
    most_alike = std::max(most_alike, alike);
  }
  REQUIRE(most_alike >= 8);
  CHECK(wrong_particles(scene, model, *executor) == 0);
}

TEST_CASE_TEMPLATE("threads that all add to one particle lose nothing", Real, float, double) {
  Scene star;
  for (Index i = 0; i <= 6000; ++i) star.add_particle(1.0, Vec3::Zero());
  for (Index i = 0; i < 6000; ++i) star.add_spring(i, 6000, 1.0, 0.0);
  star = in_whole_numbers(std::move(star));
  test::FineExecutor executor(4);
  for (auto accumulation : {Accumulation::coloured, Accumulation::atomic}) {
    const auto model = model_in_batches<Real>(star, Order(6001, ""), accumulation, 2, executor);
    CHECK(wrong_particles(star, model, executor) == 0);
  }
}

TEST_CASE("a step that is broken off leaves no sums behind") {
  const Scene scene = in_whole_numbers(many_lanes_one_neighbour());
  const auto executor = make_tbb_executor(1);
  const auto model = model_in_batches<float>(scene, Order(70, ""), Accumulation::coloured, 1, *executor);
  const State<float> state = initial_state(scene, model);
  Forces<float> forces(scene, model);
  forces.prepare(state, state.time, *executor);
  forces.clear();
  StripForce<float> force;
  forces.on_strip(Strip<float>(state, 0, block_count(70)), state, 0.0, force);
  for (std::size_t lane = 0; lane < 70; ++lane) {
    CHECK(force.x[lane] == 0.0f);
    CHECK(force.y[lane] == 0.0f);
    CHECK(force.z[lane] == 0.0f);
  }
}
