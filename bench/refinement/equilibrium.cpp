#include "refinement/equilibrium.h"

#include <algorithm>
#include <stdexcept>

namespace hooke::bench {

std::vector<Vec3> positions_of(const Simulation<double>& simulation) {
  std::vector<Vec3> positions(simulation.particle_count());
  simulation.copy_positions(positions[0].data(), sizeof(Vec3));
  return positions;
}

std::vector<Vec3> equilibrium(const Scene& scene, double step, double still) {
  Simulation<double> simulation(scene, {.method = BackwardEuler{.tolerance = 0.1 * still}, .step = step});
  std::vector<Vec3> before = positions_of(simulation);
  for (int i = 0; i < 2000; ++i) {
    if (const Report report = simulation.step(); !report.ok()) throw std::runtime_error(report.message());
    std::vector<Vec3> now = positions_of(simulation);
    double moved = 0.0;
    for (std::size_t p = 0; p < now.size(); ++p) moved = std::max(moved, (now[p] - before[p]).norm());
    if (moved < still) return now;
    before = std::move(now);
  }
  throw std::runtime_error("a sheet does not come to rest");
}

}  // namespace hooke::bench
