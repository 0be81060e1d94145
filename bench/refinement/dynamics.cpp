#include "refinement/dynamics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "refinement/equilibrium.h"

namespace hooke::bench {
namespace {

constexpr double pi = std::numbers::pi;

bool on_rim(const SheetShape& shape, Index i, Index j) {
  return i == 0 || j == 0 || i == shape.columns || j == shape.rows;
}

/// The start: strained evenly, which is at rest, and moving up as the lowest oscillation does.
Snapshot<double> strained_start(const Scene& scene, const Simulation<double>& simulation, double strain) {
  Snapshot<double> start = simulation.snapshot();
  for (std::size_t p = 0; p < scene.particles.size(); ++p) {
    const Vec3& x = scene.particles.position[p];
    for (std::size_t k = 0; k < 3; ++k) start.positions[3 * p + k] = (1.0 + strain) * x[Eigen::Index(k)];
    start.velocities[3 * p + 2] = 1e-3 * std::sin(pi * x.x()) * std::sin(-pi * x.y());
  }
  return start;
}

/// How the oscillation that began with looks now: 0 where it goes through the plane.
double amplitude(const Scene& scene, const Simulation<double>& simulation) {
  const std::vector<Vec3> now = positions_of(simulation);
  double sum = 0.0;
  for (std::size_t p = 0; p < now.size(); ++p) {
    const Vec3& x = scene.particles.position[p];
    sum += scene.particles.mass[p] * now[p].z() * std::sin(pi * x.x()) * std::sin(-pi * x.y());
  }
  return sum;
}

/// The time [s] until the sheet goes through its plane: half a period.
double half_period(const Scene& scene, Simulation<double>& simulation, double about) {
  const double h = simulation.settings().step;
  const auto take = [&](std::uint64_t steps) {
    if (const Report report = simulation.step(steps); !report.ok())
      throw std::runtime_error(report.message());
  };
  take(std::uint64_t(0.8 * about / h));
  double before = amplitude(scene, simulation);
  while (simulation.time() < 2.0 * about) {
    take(1);
    const double now = amplitude(scene, simulation);
    if (before > 0.0 && now <= 0.0) return simulation.time() - h * now / (now - before);
    before = now;
  }
  throw std::runtime_error("a membrane does not swing back");
}

/// A sheet that is held by its upper corners, which come nearer within a second.
Scene hung_by_corners(const SheetShape& shape, Mode mode) {
  Scene scene = make_sheet(shape, Pattern::grid, mode);
  constexpr double nearer = 0.05;
  const Index n = shape.columns;
  scene.pin(shape.particle(0, 0), {{0.0, Vec3::Zero()}, {1.0, {nearer, 0.0, 0.0}}});
  scene.pin(shape.particle(n, 0), {{0.0, Vec3::Zero()}, {1.0, {-nearer, 0.0, 0.0}}});
  scene.effects.emplace_back(bending_of(GridParticles{0, n + 1, n + 1}, shape.cell, 1e-3));
  // A little aslant, so that it knows on which side to fold.
  scene.effects.emplace_back(Gravity{{0.0, -9.81, 0.1}});
  return scene;
}

/// Where the particles of a sheet of n x n cells are in one of n / 2 x n / 2: between their neighbours.
std::vector<Vec3> divided(const std::vector<Vec3>& coarse, Index n) {
  const auto at = [&](Index i, Index j) { return coarse[j * (n / 2 + 1) + i]; };
  std::vector<Vec3> fine;
  for (Index j = 0; j <= n; ++j) {
    for (Index i = 0; i <= n; ++i) {
      const Index right = (i + 1) / 2, below = (j + 1) / 2;
      fine.push_back(0.25 * (at(i / 2, j / 2) + at(right, j / 2) + at(i / 2, below) + at(right, below)));
    }
  }
  return fine;
}

/// The sheet at rest: from flat where it is coarse, else from where one of half as many cells rests.
std::vector<Vec3> draped(Index n, Mode mode) {
  constexpr double step = 0.05, still = 2e-6;
  const Scene scene = hung_by_corners({n, n, 1.0 / n}, mode);
  if (n <= 8) return equilibrium(scene, step, still);
  return equilibrium_from(divided(draped(n / 2, mode), n), 1.0, scene, step, still);
}

}  // namespace

double relative_membrane_frequency(Index n, Pattern pattern, Mode mode) {
  constexpr double strain = 1e-3;
  const SheetShape shape{n, n, 1.0 / n};
  Scene scene = make_sheet(shape, pattern, mode);
  for (Index j = 0; j <= n; ++j) {
    for (Index i = 0; i <= n; ++i) {
      if (!on_rim(shape, i, j)) continue;
      const Index p = shape.particle(i, j);
      scene.pin(p, {{0.0, strain * scene.particles.position[p]}});
    }
  }
  const double stress = study_material.modulus / (1.0 - study_material.poisson_ratio) * strain;
  const double expected = std::sqrt(2.0 * stress / study_material.areal_density) / 2.0;
  Simulation<double> simulation(scene, {.method = Verlet{}, .step = 2.5e-3 / n});
  simulation.restore(strained_start(scene, simulation, strain));
  return 0.5 / half_period(scene, simulation, 0.5 / expected) / expected;
}

double drape_depth(Index n, Mode mode) {
  double lowest = 0.0;
  for (const Vec3& x : draped(n, mode)) lowest = std::min(lowest, x.y());
  return -lowest;
}

}  // namespace hooke::bench
