#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "scene/measures.h"

using namespace hooke;
using namespace hooke::test;

namespace {

ClothGrid grid_of(Index columns, Index rows) {
  return {.columns = columns, .rows = rows, .spacing = 0.1, .stretch = 3, .shear = 2, .bend = 1};
}

}  // namespace

TEST_CASE("a grid of m x n particles has Provot's springs") {
  for (const auto& [m, n] : std::vector<std::pair<Index, Index>>{{2, 2}, {2, 7}, {3, 3}, {8, 5}, {64, 33}}) {
    CAPTURE(m);
    CAPTURE(n);
    Scene scene;
    add(scene, grid_of(m, n));
    CHECK(scene.particles.size() == m * n);
    CHECK(count_springs(scene, 3) == m * (n - 1) + n * (m - 1));
    CHECK(count_springs(scene, 2) == 2 * (m - 1) * (n - 1));
    CHECK(count_springs(scene, 1) == m * (n - 2) + n * (m - 2));
    CHECK(scene.springs.size() ==
          count_springs(scene, 3) + count_springs(scene, 2) + count_springs(scene, 1));
    CHECK(scene.triangles.size() == 2 * (m - 1) * (n - 1));
    CHECK(validate(scene).empty());
  }
}

TEST_CASE("no two springs of a grid join the same particles") {
  Scene scene;
  add(scene, grid_of(7, 5));
  std::set<std::pair<Index, Index>> pairs;
  for (std::size_t i = 0; i < scene.springs.size(); ++i) {
    pairs.insert(std::minmax(scene.springs.first[i], scene.springs.second[i]));
  }
  CHECK(pairs.size() == scene.springs.size());
}

TEST_CASE("a stiffness of zero makes no springs of that kind") {
  Scene scene;
  ClothGrid cloth = grid_of(5, 5);
  cloth.shear = 0.0;
  cloth.bend = 0.0;
  add(scene, cloth);
  CHECK(scene.springs.size() == 40);
  CHECK(count_springs(scene, 3) == 40);
}

TEST_CASE("particles are numbered row by row from the origin, along +x and down -y") {
  Scene scene;
  const GridParticles grid = add(scene, grid_of(4, 3));
  CHECK(grid.at(0, 0) == 0);
  CHECK(grid.at(3, 0) == 3);
  CHECK(grid.at(0, 1) == 4);
  CHECK(scene.particles.position[0] == Vec3(0, 0, 0));
  CHECK(scene.particles.position[grid.at(3, 2)].isApprox(Vec3(0.3, -0.2, 0), 1e-15));
}

TEST_CASE("a grid's mass is its area's and does not depend on the resolution") {
  for (const Index cells : {1u, 2u, 7u, 100u}) {
    CAPTURE(cells);
    Scene scene;
    add(scene,
        ClothGrid{.columns = 2 * cells + 1, .rows = cells + 1, .spacing = 1.0 / cells, .areal_density = 0.3});
    CHECK(std::abs(total_mass(scene) / 0.6 - 1.0) < 1e-12);
  }
}

TEST_CASE("particles at an edge carry half a cell, at a corner a quarter") {
  Scene scene;
  const GridParticles grid =
      add(scene, ClothGrid{.columns = 3, .rows = 3, .spacing = 2.0, .areal_density = 1.0});
  CHECK(scene.particles.mass[grid.at(0, 0)] == 1.0);
  CHECK(scene.particles.mass[grid.at(1, 2)] == 2.0);
  CHECK(scene.particles.mass[grid.at(1, 1)] == 4.0);
}

TEST_CASE("a placed grid is at rest, and springs of one kind have the same bits") {
  Scene scene;
  ClothGrid cloth = grid_of(20, 30);
  cloth.placement = {
      .translation = {1, -2, 3}, .rotation_axis = {1, 2, -0.5}, .rotation_degrees = 37, .scale = 0.7};
  add(scene, cloth);
  CHECK(worst_strain(scene) < 1e-12);
  const double cell = 0.1 * 0.7;
  for (std::size_t i = 0; i < scene.springs.size(); ++i) {
    const double kind = scene.springs.stiffness[i];
    const double expected = kind == 3 ? cell : kind == 2 ? std::sqrt(2.0) * cell : 2.0 * cell;
    REQUIRE(scene.springs.rest_length[i] == expected);
  }
  CHECK(std::abs(total_mass(scene) / (0.2 * 19 * 29 * cell * cell) - 1.0) < 1e-12);
}

TEST_CASE("all triangles of a grid face +z and cover it") {
  Scene scene;
  add(scene, grid_of(6, 4));
  double area = 0.0;
  for (const Triangle& triangle : scene.triangles) {
    const Vec3 normal = normal_of(scene, triangle);
    CHECK(normal.z() > 0.0);
    area += 0.5 * normal.norm();
  }
  CHECK(area == doctest::Approx(0.5 * 0.3));
}

TEST_CASE("a second grid follows the first") {
  Scene scene = occupied_scene();
  const Index before = static_cast<Index>(scene.particles.size());
  const std::size_t springs_before = scene.springs.size();
  const GridParticles grid = add(scene, grid_of(3, 3));
  CHECK(grid.first == before);
  CHECK(scene.particles.velocity.size() == scene.particles.size());
  CHECK(scene.springs.damping.size() == scene.springs.size());
  CHECK(*std::min_element(scene.springs.first.begin() + springs_before, scene.springs.first.end()) == before);
  CHECK(validate(scene).empty());
}

TEST_CASE("damping is on every spring, also where the springs before had none") {
  Scene scene;
  add(scene, grid_of(2, 2));
  ClothGrid damped = grid_of(2, 2);
  damped.damping = 0.5;
  add(scene, damped);
  CHECK(scene.springs.damping == std::vector<double>{0, 0, 0, 0, 0, 0, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5});
}

TEST_CASE("a first grid holds no more memory than it needs, and many small ones grow by a factor") {
  Scene scene;
  add(scene, grid_of(50, 50));
  CHECK(scene.springs.first.capacity() == scene.springs.size());
  CHECK(scene.particles.position.capacity() == scene.particles.size());
  CHECK(scene.triangles.capacity() == scene.triangles.size());

  int reallocations = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::size_t capacity = scene.particles.position.capacity();
    add(scene, grid_of(4, 4));
    reallocations += scene.particles.position.capacity() != capacity;
  }
  CHECK(reallocations < 10);
}

TEST_CASE("bad parameters of a grid are all named, and the scene stays as it was") {
  Scene scene = occupied_scene();
  const ClothGrid cloth{.columns = 1,
                        .rows = 0,
                        .spacing = 0,
                        .areal_density = -1,
                        .stretch = -2,
                        .shear = NAN,
                        .bend = INFINITY,
                        .damping = -3,
                        .placement = {.translation = {NAN, 0, 0}, .rotation_axis = {0, 0, 0}, .scale = -1}};
  const std::vector<std::string> expected{
      "cloth_grid: columns is 1; give at least 2",
      "cloth_grid: rows is 0; give at least 2",
      "cloth_grid: spacing is 0 m; give a finite value > 0",
      "cloth_grid: areal_density is -1 kg/m^2; give a finite value > 0",
      "cloth_grid: stretch is -2 N/m; give a finite value >= 0",
      "cloth_grid: shear is nan N/m; give a finite value >= 0",
      "cloth_grid: bend is inf N/m; give a finite value >= 0",
      "cloth_grid: damping is -3 N s/m; give a finite value >= 0",
      "cloth_grid: placement.translation is (nan, 0, 0) m; give finite values",
      "cloth_grid: placement.rotation_axis is (0, 0, 0); give finite values that are not all zero",
      "cloth_grid: placement.scale is -1; give a finite value > 0"};
  CHECK(messages_of([&] { add(scene, cloth); }) == expected);
  CHECK(same_arrays(scene, occupied_scene()));
}

TEST_CASE("a grid of more particles or springs than can be numbered is refused before memory is asked for") {
  Scene scene = occupied_scene();
  CHECK(messages_of([&] {
          add(scene, ClothGrid{.columns = 65536, .rows = 65536, .stretch = 0, .shear = 0, .bend = 0});
        }) == std::vector<std::string>{
                  "cloth_grid: makes a scene of 4294967299 particles; make it of at most 4294967295",
                  "cloth_grid: makes a scene of 8589672451 triangles; make it of at most 4294967295"});
  CHECK(messages_of([&] { add(scene, ClothGrid{.columns = 4294967295, .rows = 4294967295}); }).size() == 3);
  CHECK(messages_of([&] { add(scene, ClothGrid{.columns = 30000, .rows = 30000}); }) ==
        std::vector<std::string>{
            "cloth_grid: makes a scene of 5399700003 springs; make it of at most 4294967295"});
  CHECK(same_arrays(scene, occupied_scene()));
}

TEST_CASE("good parameters that multiply to no mass or no place are refused") {
  Scene scene = occupied_scene();
  CHECK(messages_of([&] { add(scene, ClothGrid{.spacing = 1e-200}); }) ==
        std::vector<std::string>{"cloth_grid: mass of the first particle is 0 kg; give a finite value > 0"});
  CHECK(messages_of([&] {
          add(scene,
              ClothGrid{.columns = 1000, .rows = 1000, .spacing = 1e154, .placement = {.scale = 1e154}});
        }).size() == 2);
  CHECK(same_arrays(scene, occupied_scene()));
}
