#include "model/spring_colours.h"

#include <doctest/doctest.h>

#include <set>

#include "irregular_mesh.h"
#include "model/adjacency.h"
#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

SpringColours colours_of(const Scene& scene) {
  const Adjacency adjacency(scene.springs, scene.particles.size());
  return colour_springs(scene.springs, choose_order(scene.springs, adjacency, scene.particles.size()));
}

/// Each spring that pulls or damps is there once, and in no colour is a particle twice.
void check_valid(const Scene& scene) {
  const SpringColours colours = colours_of(scene);
  std::set<Index> seen;
  for (std::size_t c = 0; c < colours.colours(); ++c) {
    std::set<Index> particles;
    for (std::size_t s = colours.begin[c]; s < colours.begin[c + 1]; ++s) {
      const Index spring = colours.springs[s];
      REQUIRE(seen.insert(spring).second);
      REQUIRE(particles.insert(scene.springs.first[spring]).second);
      REQUIRE(particles.insert(scene.springs.second[spring]).second);
    }
  }
  for (Index s = 0; s < scene.springs.size(); ++s) {
    const bool acts = scene.springs.stiffness[s] > 0.0 || scene.springs.damping_of(s) > 0.0;
    REQUIRE(seen.count(s) == (acts ? 1 : 0));
  }
}

}  // namespace

TEST_CASE("no two springs of one colour share a particle, in random networks, grids and meshes") {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    check_valid(RandomNetwork(seed).make());
  }
  check_valid(hung_cloth(40, 30));
  Scene mesh;
  add(mesh, irregular_mesh(30));
  check_valid(mesh);
  check_valid(one_particle());
}

TEST_CASE("a grid takes few more colours than a particle has springs") {
  const SpringColours colours = colours_of(hung_cloth(81, 81));
  CHECK(colours.colours() >= 12);
  CHECK(colours.colours() <= 20);
}

TEST_CASE("a hub of many springs has a colour for each, beyond 64 too") {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  for (Index i = 1; i <= 200; ++i) {
    scene.add_particle(1.0, Vec3(i, 0, 0));
    scene.add_spring(0, i, i == 7 ? 0.0 : 1.0, 1.0);
  }
  CHECK(colours_of(scene).colours() == 199);
  check_valid(scene);
}
