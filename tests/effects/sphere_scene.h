#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <hooke/scene.h>

namespace hooke::test {

/// A sphere of triangles with springs along their edges: an octahedron whose triangles are cut into four,
/// `times` times. Corners are anticlockwise from outside.
inline Scene sphere_scene(int times, double radius, double stiffness, const Vec3& centre = Vec3::Zero()) {
  Scene scene;
  std::vector<Vec3> unit = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<Triangle> triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                     {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int n = 0; n < times; ++n) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
      const auto [found, made] = middles.try_emplace(std::minmax(a, b), Index(unit.size()));
      if (made) unit.push_back((unit[a] + unit[b]).normalized());
      return found->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : triangles) {
      const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    triangles = std::move(finer);
  }
  for (const Vec3& x : unit) scene.add_particle(0.01, centre + radius * x);
  for (const auto& [a, b, c] : triangles) {
    for (const auto& [i, j] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      if (i < j && stiffness > 0.0) scene.add_spring(i, j, stiffness, radius * (unit[i] - unit[j]).norm());
    }
  }
  scene.triangles = std::move(triangles);
  return scene;
}

}  // namespace hooke::test
