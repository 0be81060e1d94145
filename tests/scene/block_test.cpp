#include <doctest/doctest.h>

#include <map>
#include <utility>

#include "scene/measures.h"

using namespace hooke;
using namespace hooke::test;

namespace {

Block block_of(Index nx, Index ny, Index nz) {
  return {.nx = nx, .ny = ny, .nz = nz, .spacing = 0.5, .density = 8, .stretch = 3, .shear = 2, .body = 1};
}

/// Volume inside the surface, by the divergence theorem: negative if the triangles face inwards.
double enclosed_volume(const Scene& scene) {
  double volume = 0.0;
  for (const Triangle& triangle : scene.triangles) {
    volume += scene.particles.position[triangle[0]].dot(normal_of(scene, triangle)) / 6.0;
  }
  return volume;
}

}  // namespace

TEST_CASE("a block of nx x ny x nz particles has springs along axes, across faces and across cells") {
  for (const auto& [nx, ny, nz] : std::vector<std::array<Index, 3>>{{2, 2, 2}, {3, 4, 5}, {2, 6, 3}}) {
    CAPTURE(nx);
    CAPTURE(ny);
    CAPTURE(nz);
    Scene scene;
    add(scene, block_of(nx, ny, nz));
    const Index cx = nx - 1, cy = ny - 1, cz = nz - 1;
    CHECK(scene.particles.size() == nx * ny * nz);
    CHECK(count_springs(scene, 3) == cx * ny * nz + nx * cy * nz + nx * ny * cz);
    CHECK(count_springs(scene, 2) == 2 * (cx * cy * nz + cx * ny * cz + nx * cy * cz));
    CHECK(count_springs(scene, 1) == 4 * cx * cy * cz);
    CHECK(scene.triangles.size() == 4 * (cx * cy + cy * cz + cz * cx));
    CHECK(validate(scene).empty());
  }
}

TEST_CASE("a block is numbered along x, then y, then z") {
  Scene scene = occupied_scene();
  const BlockParticles block = add(scene, block_of(2, 3, 4));
  CHECK(block.at(0, 0, 0) == 3);
  CHECK(scene.particles.position[block.at(0, 0, 0)] == Vec3(0, 0, 0));
  CHECK(scene.particles.position[block.at(1, 0, 0)] == Vec3(0.5, 0, 0));
  CHECK(scene.particles.position[block.at(1, 2, 3)] == Vec3(0.5, 1.0, 1.5));
}

TEST_CASE(
    "a block's mass is its volume's: a corner has an eighth of a cell, an edge a quarter, a face half") {
  Scene scene;
  const BlockParticles block = add(scene, block_of(3, 3, 3));  // a cell has 1 kg
  CHECK(scene.particles.mass[block.at(0, 0, 0)] == 0.125);
  CHECK(scene.particles.mass[block.at(1, 0, 2)] == 0.25);
  CHECK(scene.particles.mass[block.at(1, 1, 0)] == 0.5);
  CHECK(scene.particles.mass[block.at(1, 1, 1)] == 1.0);
  for (const Index cells : {1u, 3u, 20u}) {
    CAPTURE(cells);
    Scene fine;
    add(fine,
        Block{.nx = cells + 1, .ny = 2 * cells + 1, .nz = cells + 1, .spacing = 1.0 / cells, .density = 5});
    CHECK(std::abs(total_mass(fine) / 10.0 - 1.0) < 1e-12);
  }
}

TEST_CASE("a placed block is at rest, and springs of one kind have the same bits") {
  Scene scene;
  Block block = block_of(4, 5, 6);
  block.placement = {
      .translation = {0, 2, 0}, .rotation_axis = {1, 1, 1}, .rotation_degrees = -75, .scale = 3};
  add(scene, block);
  CHECK(worst_strain(scene) < 1e-12);
  std::map<double, double> rest_of_kind;
  for (std::size_t i = 0; i < scene.springs.size(); ++i) {
    const double rest = scene.springs.rest_length[i];
    REQUIRE(rest_of_kind.try_emplace(scene.springs.stiffness[i], rest).first->second == rest);
  }
  CHECK(rest_of_kind.at(3) == 1.5);
  CHECK(std::abs(total_mass(scene) / (8 * 60 * 3.375) - 1.0) < 1e-12);
}

TEST_CASE("a block's surface is closed and faces outwards") {
  Scene scene;
  add(scene, block_of(3, 4, 5));
  std::map<std::pair<Index, Index>, int> directed;
  for (const Triangle& t : scene.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++directed[{t[i], t[(i + 1) % 3]}];
  }
  for (const auto& [edge, count] : directed) {
    CHECK(count == 1);
    CHECK(directed.count({edge.second, edge.first}) == 1);
  }
  CHECK(enclosed_volume(scene) == doctest::Approx(1.0 * 1.5 * 2.0));
}

TEST_CASE("bad parameters of a block are all named, and the scene stays as it was") {
  Scene scene = occupied_scene();
  const Block block{.nx = 1,
                    .ny = 0,
                    .nz = 1,
                    .spacing = NAN,
                    .density = 0,
                    .stretch = -1,
                    .shear = -2,
                    .body = -3,
                    .damping = -4,
                    .placement = {.rotation_degrees = INFINITY}};
  CHECK(messages_of([&] { add(scene, block); }) ==
        std::vector<std::string>{"block: nx is 1; give at least 2", "block: ny is 0; give at least 2",
                                 "block: nz is 1; give at least 2",
                                 "block: spacing is nan m; give a finite value > 0",
                                 "block: density is 0 kg/m^3; give a finite value > 0",
                                 "block: stretch is -1 N/m; give a finite value >= 0",
                                 "block: shear is -2 N/m; give a finite value >= 0",
                                 "block: body is -3 N/m; give a finite value >= 0",
                                 "block: damping is -4 N s/m; give a finite value >= 0",
                                 "block: placement.rotation_degrees is inf degrees; give a finite value"});
  CHECK(messages_of([&] {
          add(scene, Block{.nx = 4294967295, .ny = 4294967295, .nz = 4294967295});
        }).size() == 3);
  CHECK(same_arrays(scene, occupied_scene()));
}
