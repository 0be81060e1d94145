#pragma once

#include <cstddef>
#include <vector>

#include <hooke/hooke.h>

#include "scenes.h"
#include "scenes/hard/crossings.h"

namespace hooke::test {

using hard::count_crossings;

template <class Real>
std::vector<Vec3> all_positions(const Simulation<Real>& simulation, const Scene& scene) {
  std::vector<Vec3> x;
  for (Index i = 0; i < scene.particles.size(); ++i) x.push_back(position(simulation, i));
  return x;
}

template <class Real>
std::size_t count_crossings(const Simulation<Real>& simulation, const Scene& scene) {
  return count_crossings(all_positions(simulation, scene), scene.triangles);
}

}  // namespace hooke::test
