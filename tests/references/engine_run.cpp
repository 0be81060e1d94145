#include "engine_run.h"

#include <doctest/doctest.h>

#include "scenes.h"

namespace hooke::test {

std::vector<double> engine_run(const ReferenceScene& scene, const Method& method, std::uint64_t steps) {
  Simulation<double> simulation(scene.scene, {.method = method, .step = scene.end / double(steps)});
  const Report report = simulation.step(steps);
  REQUIRE_MESSAGE(report.ok(), scene.name, ": ", report.message());
  const reference::EngineForces forces(scene.scene);
  std::vector<double> y;
  for (Index i : forces.free_particles()) {
    const Vec3 x = position(simulation, i);
    y.insert(y.end(), x.begin(), x.end());
  }
  for (Index i : forces.free_particles()) {
    const Vec3 v = velocity(simulation, i);
    y.insert(y.end(), v.begin(), v.end());
  }
  return y;
}

}  // namespace hooke::test
