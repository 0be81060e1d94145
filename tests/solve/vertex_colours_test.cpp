#include "model/vertex_colours.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "irregular_mesh.h"
#include "model/slots.h"
#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

VertexColours colours_of(const Scene& scene) {
  const Adjacency adjacency(scene.springs, scene.particles.size());
  return colour_vertices(scene.springs, adjacency,
                         choose_order(scene.springs, adjacency, scene.particles.size()));
}

/// The colour of each of the user's particles; each must have exactly one.
std::vector<std::size_t> colour_of_each(const VertexColours& colours) {
  constexpr std::size_t none = ~std::size_t{0};
  std::vector<std::size_t> colour(colours.order.size(), none);
  REQUIRE(colours.begin.front() == 0);
  REQUIRE(colours.begin.back() == colours.order.size());
  for (std::size_t c = 0; c < colours.colours(); ++c) {
    REQUIRE(colours.begin[c] <= colours.begin[c + 1]);
    for (std::size_t i = colours.begin[c]; i < colours.begin[c + 1]; ++i) {
      REQUIRE(colour[colours.order.user(i)] == none);
      colour[colours.order.user(i)] = c;
    }
  }
  return colour;
}

void check_valid(const Scene& scene) {
  const std::vector<std::size_t> colour = colour_of_each(colours_of(scene));
  for (std::size_t s = 0; s < scene.springs.size(); ++s)
    REQUIRE(colour[scene.springs.first[s]] != colour[scene.springs.second[s]]);
}

}  // namespace

TEST_CASE("no spring joins two particles of one colour, in random networks") {
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    check_valid(RandomNetwork(seed).make());
  }
}

TEST_CASE("no spring joins two particles of one colour, in grids, meshes and blocks") {
  for (const Index columns : {2, 3, 7, 16, 50, 81}) check_valid(hung_cloth(columns, 20));
  Scene mesh;
  add(mesh, irregular_mesh(40));
  check_valid(mesh);
  Scene block;
  add(block, Block{});
  check_valid(block);
}

TEST_CASE("a grid takes few colours, of one size, and all its springs lie in shift slots") {
  Scene scene;
  add(scene, ClothGrid{.columns = 81, .rows = 81});
  const VertexColours colours = colours_of(scene);
  CHECK(colours.colours() <= 9);
  for (std::size_t c = 0; c < colours.colours(); ++c) {
    const std::size_t size = colours.begin[c + 1] - colours.begin[c];
    CHECK(size >= scene.particles.size() / colours.colours());
    CHECK(size <= scene.particles.size() / colours.colours() + 1);
  }
  const Adjacency adjacency(scene.springs, scene.particles.size());
  const auto slots = make_slots<float>(scene.springs, adjacency, colours.order, *make_tbb_executor(1));
  CHECK(count_slots(slots, scene.springs.size()).shift_share() > 0.97);
}

TEST_CASE("a hub takes one colour, and its many neighbours another") {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  std::mt19937 random(5);
  for (Index i = 1; i < 500; ++i) {
    scene.add_particle(1.0, Vec3(i, 0, 0));
    scene.add_spring(0, i, 1.0, 1.0);
  }
  CHECK(colours_of(scene).colours() == 2);
  check_valid(scene);
}

TEST_CASE("without springs all particles have one colour, and no particles have none") {
  CHECK(colours_of(one_particle()).colours() == 1);
  CHECK(colours_of(Scene{}).colours() == 0);
}
