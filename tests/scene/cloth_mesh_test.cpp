#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>
#include <random>
#include <set>

#include "scene/measures.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// Two triangles that share the edge from (0, 0) to (1, 1).
ClothMesh square() {
  ClothMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.stretch = 3;
  mesh.bend = 1;
  return mesh;
}

/// A tube of `around` x `along` quads. Open, its seam has every vertex twice, moved apart by `gap` [m].
ClothMesh tube(Index around, Index along, bool open, double gap = 0.0) {
  ClothMesh mesh;
  mesh.stretch = 3;
  mesh.bend = 1;
  const Index columns = open ? around + 1 : around;
  for (Index row = 0; row <= along; ++row) {
    for (Index column = 0; column < columns; ++column) {
      const double angle = 2.0 * std::numbers::pi * (column % around) / around;
      mesh.vertices.push_back({std::cos(angle), 0.3 * row, std::sin(angle) + (column == around ? gap : 0.0)});
    }
  }
  for (Index row = 0; row < along; ++row) {
    for (Index column = 0; column < around; ++column) {
      const Index next = (column + 1) % columns;
      const Index a = row * columns + column, b = row * columns + next;
      mesh.triangles.push_back({a, b, a + columns});
      mesh.triangles.push_back({b, b + columns, a + columns});
    }
  }
  return mesh;
}

std::set<std::pair<Index, Index>> pairs_of(const Scene& scene, double stiffness) {
  std::set<std::pair<Index, Index>> pairs;
  for (std::size_t i = 0; i < scene.springs.size(); ++i) {
    if (scene.springs.stiffness[i] != stiffness) continue;
    pairs.insert(std::minmax(scene.springs.first[i], scene.springs.second[i]));
  }
  return pairs;
}

using Pairs = std::set<std::pair<Index, Index>>;

}  // namespace

TEST_CASE("edges become structural springs, opposite corners bend springs") {
  Scene scene;
  const MeshParticles cloth = add(scene, square());
  CHECK(cloth.count == 4);
  CHECK(cloth.of_vertex == std::vector<Index>{0, 1, 2, 3});
  CHECK(pairs_of(scene, 3) == Pairs{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}});
  CHECK(pairs_of(scene, 1) == Pairs{{1, 3}});
  CHECK(scene.springs.size() == 6);
  CHECK(scene.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
  CHECK(worst_strain(scene) == 0.0);
  CHECK(validate(scene).empty());
}

TEST_CASE("a third of each triangle's mass goes to each corner, after scaling") {
  Scene scene;
  ClothMesh mesh = square();
  mesh.areal_density = 6.0;
  mesh.placement = {.translation = {5, 0, 0}, .rotation_degrees = 30, .scale = 2};
  add(scene, mesh);
  const std::vector<double> expected{8, 4, 8, 4};
  for (std::size_t i = 0; i < 4; ++i)
    CHECK(scene.particles.mass[i] == doctest::Approx(expected[i]).epsilon(1e-14));
  CHECK(worst_strain(scene) < 1e-12);
  CHECK((scene.particles.position[2] - scene.particles.position[0]).norm() ==
        doctest::Approx(2 * std::sqrt(2.0)));
}

TEST_CASE("a mesh after other things is numbered from there") {
  Scene scene = occupied_scene();
  const MeshParticles cloth = add(scene, square());
  CHECK(cloth.first == 3);
  CHECK(cloth.of_vertex == std::vector<Index>{3, 4, 5, 6});
  CHECK(scene.triangles.back() == Triangle{3, 5, 6});
  CHECK(validate(scene).empty());
}

TEST_CASE("a tube whose seam is doubled becomes the closed tube") {
  Scene closed, open;
  const MeshParticles whole = add(closed, tube(12, 5, false));
  const MeshParticles welded = add(open, tube(12, 5, true, 5e-7));
  CHECK(whole.welded_vertices == 0);
  CHECK(welded.welded_vertices == 6);
  CHECK(welded.count == whole.count);
  CHECK(welded.of_vertex[12] == welded.of_vertex[0]);
  CHECK(count_springs(open, 3) == count_springs(closed, 3));
  CHECK(count_springs(open, 1) == count_springs(closed, 1));
  CHECK(count_springs(closed, 3) == 12 * 6 + 2 * 12 * 5);       // around, along and diagonal
  CHECK(count_springs(closed, 1) == 12 * 5 + 12 * 5 + 12 * 4);  // one for each inner edge
  CHECK(total_mass(open) == doctest::Approx(total_mass(closed)));
}

TEST_CASE("vertices at just the tolerance are welded, further ones are not") {
  ClothMesh mesh = square();
  mesh.vertices.push_back({1.0, 1.25, 0.0});
  mesh.triangles.push_back({3, 2, 4});
  for (const auto& [tolerance, particles] :
       std::vector<std::pair<double, Index>>{{0.25, 4}, {0.2499, 5}, {0.0, 5}}) {
    CAPTURE(tolerance);
    Scene scene;
    mesh.weld_tolerance = tolerance;
    CHECK(add(scene, mesh).count == particles);
  }
}

TEST_CASE("tolerance zero welds equal vertices only") {
  Scene scene;
  ClothMesh mesh = tube(8, 2, true);
  mesh.weld_tolerance = 0.0;
  mesh.vertices[0].z() = -0.0;  // the same place as 0.0
  CHECK(add(scene, mesh).welded_vertices == 3);
}

TEST_CASE("a chain of close vertices ends at the lowest number within the tolerance, in order") {
  ClothMesh mesh = square();
  mesh.weld_tolerance = 0.1;
  mesh.vertices.push_back({1.08, 1, 0});  // 4: within the tolerance of 2
  mesh.vertices.push_back({1.16, 1, 0});  // 5: within that of 4, which stands for nothing, but not of 2
  mesh.vertices.push_back({1.24, 1, 0});  // 6: within that of 5
  mesh.triangles.push_back({1, 5, 4});
  Scene scene;
  const MeshParticles cloth = add(scene, mesh);
  CHECK(cloth.of_vertex == std::vector<Index>{0, 1, 2, 3, 2, 4, 4});
  CHECK(cloth.welded_vertices == 2);
}

TEST_CASE("welding finds what a search through all vertices finds") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (const double tolerance : {0.0, 1e-3, 0.05, 0.3}) {
    CAPTURE(tolerance);
    ClothMesh mesh;
    mesh.weld_tolerance = tolerance;
    for (int i = 0; i < 600; ++i)
      mesh.vertices.push_back({coordinate(random), coordinate(random), coordinate(random)});
    for (int i = 0; i < 100; ++i) mesh.vertices.push_back(mesh.vertices[i]);
    mesh.triangles.push_back({0, 1, 2});
    // Each vertex in a large triangle of its own with two far corners, so that all are used.
    mesh.vertices.insert(mesh.vertices.end(), {{50, 0, 0}, {0, 50, 0}});
    for (Index i = 0; i < 700; ++i) mesh.triangles.push_back({i, 700, 701});

    std::vector<Index> expected(mesh.vertices.size());
    Index count = 0;
    std::vector<Index> standing;
    for (Index i = 0; i < mesh.vertices.size(); ++i) {
      const auto near = std::find_if(standing.begin(), standing.end(), [&](Index other) {
        return (mesh.vertices[i] - mesh.vertices[other]).norm() <= tolerance;
      });
      expected[i] = near == standing.end() ? count++ : expected[*near];
      if (near == standing.end()) standing.push_back(i);
    }
    Scene scene;
    CHECK(add(scene, mesh).of_vertex == expected);
  }
}

TEST_CASE("an edge of three triangles has three bend springs") {
  ClothMesh mesh = square();
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}, {0.5, 0, 1}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  Scene scene;
  add(scene, mesh);
  CHECK(count_springs(scene, 3) == 7);
  CHECK(pairs_of(scene, 1) == Pairs{{2, 3}, {2, 4}, {3, 4}});
  CHECK(scene.springs.size() == 10);
}

TEST_CASE("no bend spring lies on an edge or on another bend spring") {
  ClothMesh tetrahedron = square();  // each pair of opposite corners is an edge
  tetrahedron.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  Scene scene;
  add(scene, tetrahedron);
  CHECK(count_springs(scene, 3) == 6);
  CHECK(count_springs(scene, 1) == 0);

  ClothMesh octahedron = square();  // four edges have the same two opposite corners
  octahedron.vertices = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  octahedron.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4},
                          {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}};
  Scene second;
  add(second, octahedron);
  CHECK(count_springs(second, 3) == 12);
  CHECK(pairs_of(second, 1) == Pairs{{0, 2}, {1, 3}, {4, 5}});
  CHECK(count_springs(second, 1) == 3);
}

TEST_CASE("a triangle given twice, also turned over, adds mass but no springs") {
  ClothMesh mesh = square();
  mesh.triangles.push_back({0, 1, 2});
  mesh.triangles.push_back({2, 1, 0});
  Scene once, twice;
  add(once, square());
  add(twice, mesh);
  CHECK(twice.springs.first == once.springs.first);
  CHECK(twice.springs.second == once.springs.second);
  CHECK(twice.triangles.size() == 4);
  CHECK(total_mass(twice) == doctest::Approx(2.0 * total_mass(once)));
}

TEST_CASE("degenerate triangles and unused vertices are left out and counted") {
  ClothMesh mesh = square();
  mesh.vertices.push_back({2, 0, 0});     // 4: only in triangles without an area
  mesh.vertices.push_back({9, 9, 9});     // 5: in no triangle
  mesh.vertices.push_back({9, 9, 9});     // 6: welded to one in no triangle
  mesh.vertices.push_back({0, 0, 1e-9});  // 7: welded to one that is used
  mesh.triangles.push_back({0, 1, 4});    // on a line
  mesh.triangles.push_back({1, 1, 2});    // a corner twice
  mesh.triangles.push_back({0, 7, 2});    // two corners that are one
  Scene scene;
  const MeshParticles cloth = add(scene, mesh);
  constexpr Index none = MeshParticles::none;
  CHECK(cloth.of_vertex == std::vector<Index>{0, 1, 2, 3, none, none, none, 0});
  CHECK(cloth.count == 4);
  CHECK(cloth.unused_vertices == 3);
  CHECK(cloth.welded_vertices == 1);
  CHECK(cloth.degenerate_triangles == 3);
  CHECK(scene.springs.size() == 6);
  CHECK(scene.triangles.size() == 2);
}

TEST_CASE("a triangle on a slanted line is degenerate although rounding gives it some area") {
  ClothMesh mesh = square();
  mesh.vertices.insert(mesh.vertices.end(), {{0.1, 0.2, 0.3}, {0.7, 1.4, 2.1}, {0.3, 0.6, 0.9}});
  mesh.triangles.push_back({4, 5, 6});
  Scene scene;
  CHECK(add(scene, mesh).degenerate_triangles == 1);
}

TEST_CASE("zero stiffness makes no springs of that kind") {
  ClothMesh mesh = square();
  mesh.stretch = 0.0;
  Scene bend_only;
  add(bend_only, mesh);
  CHECK(pairs_of(bend_only, 1) == Pairs{{1, 3}});
  CHECK(bend_only.springs.size() == 1);

  mesh.stretch = 3.0;
  mesh.bend = 0.0;
  Scene stretch_only;
  add(stretch_only, mesh);
  CHECK(stretch_only.springs.size() == 5);
}

TEST_CASE("bad parameters of a mesh are all named, and the scene stays as it was") {
  Scene scene = occupied_scene();
  ClothMesh mesh = square();
  mesh.vertices[1].x() = NAN;
  mesh.triangles[1][2] = 4;
  mesh.areal_density = 0;
  mesh.stretch = -1;
  mesh.bend = -2;
  mesh.damping = -3;
  mesh.weld_tolerance = -4;
  mesh.placement.scale = 0;
  CHECK(messages_of([&] { add(scene, mesh); }) ==
        std::vector<std::string>{"cloth_mesh: areal_density is 0 kg/m^2; give a finite value > 0",
                                 "cloth_mesh: stretch is -1 N/m; give a finite value >= 0",
                                 "cloth_mesh: bend is -2 N/m; give a finite value >= 0",
                                 "cloth_mesh: damping is -3 N s/m; give a finite value >= 0",
                                 "cloth_mesh: weld_tolerance is -4 m; give a finite value >= 0",
                                 "cloth_mesh: placement.scale is 0; give a finite value > 0",
                                 "cloth_mesh vertex 1: position is (nan, 0, 0) m; give finite values",
                                 "cloth_mesh triangle 1: corner 2 is 4, but the number of vertices is 4; "
                                 "give a number from 0 to 3"});
  CHECK(same_arrays(scene, occupied_scene()));
}

TEST_CASE("a mesh without an area is refused") {
  Scene scene = occupied_scene();
  CHECK(messages_of([&] { add(scene, ClothMesh{}); }) ==
        std::vector<std::string>{"cloth_mesh: number of triangles is 0; give at least 1"});
  ClothMesh all_one = square();
  all_one.weld_tolerance = 10.0;
  CHECK(messages_of([&] { add(scene, all_one); }) ==
        std::vector<std::string>{
            "cloth_mesh: no triangle has an area once vertices within weld_tolerance are one; "
            "give a smaller tolerance or a mesh with an area"});
  CHECK(same_arrays(scene, occupied_scene()));
}

TEST_CASE("good parameters that multiply to no mass or no place are refused") {
  Scene scene = occupied_scene();
  ClothMesh mesh = square();
  mesh.placement.scale = 1e-200;
  const std::vector<std::string> messages = messages_of([&] { add(scene, mesh); });
  REQUIRE(messages.size() == 4);
  CHECK(messages[0] == "cloth_mesh vertex 0: mass is 0 kg; give a finite value > 0");
  mesh.placement = {.translation = {1.5e308, 0, 0}, .scale = 1e308};
  CHECK(messages_of([&] { add(scene, mesh); })[0].find("cloth_mesh vertex 0: mass is inf kg") == 0);
  CHECK(same_arrays(scene, occupied_scene()));
}
