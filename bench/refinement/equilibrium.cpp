#include "refinement/equilibrium.h"

#include <algorithm>
#include <stdexcept>

namespace hooke::bench {

std::vector<Vec3> positions_of(const Simulation<double>& simulation) {
  std::vector<Vec3> positions(simulation.particle_count());
  simulation.copy_positions(positions[0].data(), sizeof(Vec3));
  return positions;
}

namespace {

Settings settings(double step, double still) {
  return {.method = BackwardEuler{.tolerance = 0.1 * still}, .step = step};
}

std::vector<Vec3> come_to_rest(Simulation<double>& simulation, double still) {
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

}  // namespace

std::vector<Vec3> equilibrium(const Scene& scene, double step, double still) {
  Simulation<double> simulation(scene, settings(step, still));
  return come_to_rest(simulation, still);
}

std::vector<Vec3> equilibrium_from(const std::vector<Vec3>& start, double time, const Scene& scene,
                                   double step, double still) {
  Simulation<double> simulation(scene, settings(step, still));
  Snapshot<double> snapshot = simulation.snapshot();
  for (std::size_t p = 0; p < start.size(); ++p) {
    for (std::size_t k = 0; k < 3; ++k) snapshot.positions[3 * p + k] = start[p][Eigen::Index(k)];
  }
  snapshot.time = time;
  simulation.restore(snapshot);
  return come_to_rest(simulation, still);
}

}  // namespace hooke::bench
