#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <random>

#include "irregular_mesh.h"
#include "model/order.h"
#include "model/tiles.h"
#include "scenes.h"
#include "state.h"

using namespace hooke;

namespace {

Order order_of(const Scene& scene) {
  const std::size_t particles = scene.particles.size();
  return choose_order(scene.springs, Adjacency(scene.springs, particles), particles);
}

bool is_permutation_of_particles(const Order& order) {
  std::vector<bool> seen(order.size(), false);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Index e = order.engine(i);
    if (e >= order.size() || seen[e] || order.user(e) != i) return false;
    seen[e] = true;
  }
  return true;
}

/// The mean distance in the order between the ends of a spring.
double mean_distance(const Scene& scene, const Order& order) {
  double sum = 0.0;
  for (std::size_t s = 0; s < scene.springs.size(); ++s) {
    sum += std::abs(double(order.engine(scene.springs.first[s])) -
                    double(order.engine(scene.springs.second[s])));
  }
  return sum / double(scene.springs.size());
}

Scene shuffled(const Scene& scene, std::uint32_t seed) {
  std::vector<Index> place(scene.particles.size());
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin(), place.end(), std::mt19937(seed));
  Scene result = scene;
  for (std::size_t i = 0; i < place.size(); ++i) {
    result.particles.position[place[i]] = scene.particles.position[i];
    result.particles.mass[place[i]] = scene.particles.mass[i];
  }
  for (Index& end : result.springs.first) end = place[end];
  for (Index& end : result.springs.second) end = place[end];
  for (Pin& pin : result.pins) pin.particle = place[pin.particle];
  return result;
}

}  // namespace

TEST_CASE("grids keep the user's numbering") {
  Scene block;
  add(block, Block{.nx = 5, .ny = 6, .nz = 7});
  Scene two_cloths = test::hung_cloth(30, 20);
  add(two_cloths, ClothGrid{.columns = 17, .rows = 40});
  Scene rope;
  add(rope, Rope{.particles = 100});
  for (const Scene& scene : {test::hung_cloth(50, 50), block, two_cloths, rope, test::one_particle()}) {
    CHECK(order_of(scene).is_identity());
  }
}

TEST_CASE("a shuffled cloth is put in an order about as local as a grid's") {
  const Scene grid = test::hung_cloth(60, 60), mixed = shuffled(grid, 3);
  const Order order = order_of(mixed);
  CHECK_FALSE(order.is_identity());
  CHECK(is_permutation_of_particles(order));
  const double best = mean_distance(grid, Order(grid.particles.size(), ""));
  CHECK(mean_distance(mixed, order) < 2.0 * best);
  CHECK(mean_distance(mixed, Order(mixed.particles.size(), "")) > 10.0 * best);
}

TEST_CASE("the springs of an irregular sheet reach little more than two rows of it") {
  constexpr Index n = 256;
  Scene scene;
  add(scene, test::irregular_mesh(n));
  const Order order = order_of(scene);
  CHECK(is_permutation_of_particles(order));
  // Springs of bending reach over two rows, and sorting by degree moves each end within a window of 4 blocks.
  // From a corner of the sheet it would be 51 blocks.
  CHECK(spring_reach(scene.springs, order) >= 2 * n / block_size);
  CHECK(spring_reach(scene.springs, order) <= 2.5 * n / block_size + 4);

  const Order again = order_of(scene);
  std::size_t differing = 0;
  for (std::size_t i = 0; i < order.size(); ++i) differing += again.engine(i) != order.engine(i);
  CHECK(differing == 0);
}

TEST_CASE("separate sheets are ordered one after the other: their springs reach no further") {
  constexpr Index n = 64;
  Scene one, many;
  add(one, test::irregular_mesh(n));
  for (std::uint32_t seed = 1; seed <= 5; ++seed) add(many, test::irregular_mesh(n, seed));
  const Order order = order_of(shuffled(many, 1));
  CHECK(is_permutation_of_particles(order));
  CHECK(spring_reach(shuffled(many, 1).springs, order) <= spring_reach(one.springs, order_of(one)) + 2);
}

TEST_CASE("every network gets a permutation, isolated particles and separate parts too") {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    CHECK(is_permutation_of_particles(order_of(test::RandomNetwork(seed).make())));
  }
}
