#pragma once

#include <numeric>
#include <random>

#include <hooke/builders.h>

namespace hooke::test {

/// A sheet of n x n jittered vertices in random order, so that neither its springs nor its numbering are
/// regular.
inline ClothMesh irregular_mesh(Index n, std::uint32_t seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> jitter(-0.3, 0.3);
  std::vector<Index> place(n * n);
  std::iota(place.begin(), place.end(), Index{0});
  std::shuffle(place.begin(), place.end(), random);

  ClothMesh mesh{.areal_density = 0.2, .stretch = 100.0, .bend = 1.0};
  mesh.vertices.resize(n * n);
  const double spacing = 1.0 / n;
  const auto at = [&](Index i, Index j) { return place[j * n + i]; };
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) {
      mesh.vertices[at(i, j)] = spacing * Vec3(i + jitter(random), -(j + jitter(random)), jitter(random));
    }
  }
  for (Index j = 0; j + 1 < n; ++j) {
    for (Index i = 0; i + 1 < n; ++i) {
      // A random diagonal makes the number of edges at a vertex vary.
      const Index a = at(i, j), b = at(i + 1, j), c = at(i, j + 1), d = at(i + 1, j + 1);
      if (random() % 2 == 0) {
        mesh.triangles.push_back({a, c, b});
        mesh.triangles.push_back({b, c, d});
      } else {
        mesh.triangles.push_back({a, c, d});
        mesh.triangles.push_back({a, d, b});
      }
    }
  }
  return mesh;
}

}  // namespace hooke::test
