#include "jittered_mesh.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

using namespace hooke;
using bench::jittered_mesh;
using bench::TriangleMesh;

namespace {

using Sides = std::map<std::pair<Index, Index>, Index>;  // each directed side, and the corner opposite it

Sides sides_of(const TriangleMesh& mesh) {
  Sides sides;
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const bool is_new = sides.insert({{t[i], t[(i + 1) % 3]}, t[(i + 2) % 3]}).second;
      REQUIRE(is_new);  // a side in the same direction twice would be two triangles on one another
    }
  }
  return sides;
}

double area(const TriangleMesh& mesh, const Triangle& t) {
  const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  return 0.5 * (b - a).cross(c - a).z();
}

/// The angle at `corner` of its triangle with a and b [rad].
double angle(const TriangleMesh& mesh, Index corner, Index a, Index b) {
  const Vec3 u = mesh.vertices[a] - mesh.vertices[corner], v = mesh.vertices[b] - mesh.vertices[corner];
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

}  // namespace

TEST_CASE("a jittered mesh covers its sheet once: no hole, no overlap, no triangle turned over") {
  const TriangleMesh mesh = jittered_mesh(90, 60);
  REQUIRE(mesh.vertices.size() == 90 * 60);
  double covered = 0.0;
  double smallest = std::numeric_limits<double>::max();
  for (const Triangle& t : mesh.triangles) {
    smallest = std::min(smallest, area(mesh, t));
    covered += area(mesh, t);
  }
  CHECK(smallest > 0.0);
  CHECK(covered == doctest::Approx(1.0 * 59.0 / 89.0).epsilon(1e-12));

  const Sides sides = sides_of(mesh);
  std::size_t border = 0;
  for (const auto& [side, corner] : sides) border += 1 - sides.count({side.second, side.first});
  CHECK(border == 2 * (89 + 59));
  const std::size_t edges = (sides.size() + border) / 2;
  CHECK(mesh.vertices.size() + mesh.triangles.size() - edges == 1);  // Euler's characteristic of a disc
}

TEST_CASE("a jittered mesh is Delaunay's triangulation: no two angles opposite an edge exceed pi") {
  const TriangleMesh mesh = jittered_mesh(90, 60);
  const Sides sides = sides_of(mesh);
  double largest = 0.0;
  for (const auto& [side, corner] : sides) {
    const auto other = sides.find({side.second, side.first});
    if (other == sides.end()) continue;
    largest = std::max(largest, angle(mesh, corner, side.first, side.second) +
                                    angle(mesh, other->second, side.first, side.second));
  }
  CHECK(largest < 3.14159265358979 + 1e-6);
  CHECK(largest > 3.0);  // there are edges near the limit, so the bound was tested
}

TEST_CASE("a jittered mesh is irregular: many valences, and numbers without order") {
  const TriangleMesh mesh = jittered_mesh(90, 60);
  std::vector<std::set<Index>> neighbours(mesh.vertices.size());
  std::set<std::int64_t> distances;
  for (const auto& [side, corner] : sides_of(mesh)) {
    neighbours[side.first].insert(side.second);
    neighbours[side.second].insert(side.first);
    distances.insert(std::abs(std::int64_t(side.first) - side.second));
  }
  std::map<std::size_t, int> of_valence;
  for (const auto& set : neighbours) ++of_valence[set.size()];
  for (std::size_t valence : {4, 5, 6, 7, 8}) CHECK(of_valence[valence] > 54);  // more than 1 %
  CHECK(of_valence[6] < 54 * 50);                                               // fewer than half
  CHECK(distances.size() > 4000);  // of 5399 that there can be: no stride is common
}

TEST_CASE("a jittered mesh is the same for the same seed, and another for another") {
  const TriangleMesh first = jittered_mesh(30, 20, 7), same = jittered_mesh(30, 20, 7);
  CHECK(first.vertices == same.vertices);
  CHECK(first.triangles == same.triangles);
  CHECK(first.vertices != jittered_mesh(30, 20, 8).vertices);
  // What no machine and no standard library may change.
  CHECK(first.vertices[0].x() == doctest::Approx(0.76019950630472).epsilon(1e-12));
  CHECK(first.vertices[0].y() == doctest::Approx(0.19961397072641).epsilon(1e-12));
  CHECK(jittered_mesh(2, 2).triangles.size() == 2);
}

TEST_CASE("a jittered mesh of a million vertices is made in seconds") {
  const auto start = std::chrono::steady_clock::now();
  const TriangleMesh mesh = jittered_mesh(1000, 1000);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  CHECK(mesh.triangles.size() == 2 * 999 * 999);
  MESSAGE("made in ", taken.count(), " s");
#ifdef NDEBUG
  CHECK(taken.count() < 10.0);
#endif
}
