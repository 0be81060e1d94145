#pragma once

#include <vector>

#include <hooke/scene.h>

#include "writers/frame.h"

namespace hooke::test {

/// Two triangles that share an edge, with springs along the edges; no two numbers of it are alike.
inline Scene two_triangles() {
  Scene scene;
  scene.add_particle(0.1, {0.0, 0.25, 0.5});
  scene.add_particle(0.2, {1.0, 0.125, -0.5});
  scene.add_particle(0.3, {0.75, 2.0, 0.0625});
  scene.add_particle(0.4, {-1.5, 1.75, 3.0});
  scene.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (const auto& [first, second] : {std::pair{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 0}}) {
    scene.add_spring(static_cast<Index>(first), static_cast<Index>(second), 10.0, 1.5);
  }
  return scene;
}

/// These two as they are torn apart along their edge: the second one has got particles 4 and 5 for 0 and 2.
inline Scene torn_triangles() {
  Scene scene = two_triangles();
  for (const Index from : {0, 2}) scene.add_particle(0.1, Vec3(scene.particles.position[from]));
  scene.triangles[1] = {4, 5, 3};
  scene.springs.first[3] = 5;
  scene.springs.second[4] = 4;
  return scene;
}

inline std::vector<Vec3> two_triangles_velocities() {
  return {{0.1, 0.2, 0.3}, {-1.0, -2.0, -3.0}, {10.0, 0.0, -20.0}, {1e-3, 1e3, 0.0}};
}

}  // namespace hooke::test
