#include "refinement/stretch.h"

#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <utility>

#include <Eigen/Core>

#include "refinement/equilibrium.h"

namespace hooke::bench {
namespace {

using Plane = Eigen::Vector2d;
using Strain = Eigen::Matrix2d;

constexpr double wanted_strain = 1e-4, long_step = 10.0, still = 1e-9;

/// A part of the rim: its ends, and its length [m] along the normal that points out of the sheet.
struct RimEdge {
  Index a, b;
  Plane outward;
};

/// The edges of one triangle alone.
std::vector<RimEdge> rim_of(const Scene& scene) {
  std::map<std::pair<Index, Index>, std::pair<int, Index>> edges;  // how often, and the corner opposite
  for (const Triangle& t : scene.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      auto& [count, opposite] = edges[std::minmax(t[(i + 1) % 3], t[(i + 2) % 3])];
      ++count;
      opposite = t[i];
    }
  }
  std::vector<RimEdge> rim;
  const auto& x = scene.particles.position;
  for (const auto& [ends, edge] : edges) {
    if (edge.first != 1) continue;
    const Vec3 along = x[ends.second] - x[ends.first];
    Plane outward(along.y(), -along.x());
    if (outward.dot((x[edge.second] - x[ends.first]).head<2>()) > 0.0) outward = -outward;
    rim.push_back({ends.first, ends.second, outward});
  }
  return rim;
}

/// The forces of an even stress on the rim, on each particle where it started.
Field rim_forces(const SheetShape& shape, const std::vector<RimEdge>& rim, const Strain& stress) {
  auto forces = std::make_shared<std::vector<Vec3>>((shape.columns + 1) * (shape.rows + 1), Vec3::Zero());
  for (const RimEdge& edge : rim) {
    const Plane half = 0.5 * stress * edge.outward;
    (*forces)[edge.a].head<2>() += half;
    (*forces)[edge.b].head<2>() += half;
  }
  // Nothing moves as far as half a cell, so a place tells the particle.
  return {.shape = CallbackField([forces, shape](const Vec3& x, double) -> Vec3 {
            return (*forces)[shape.particle(Index(std::lround(x.x() / shape.cell)),
                                            Index(std::lround(-x.y() / shape.cell)))];
          })};
}

/// The mean gradient of displacements, by the theorem of Gauss.
Strain mean_gradient(const Scene& scene, const std::vector<RimEdge>& rim, const std::vector<Vec3>& now,
                     double area) {
  const auto moved = [&](Index i) -> Plane { return (now[i] - scene.particles.position[i]).head<2>(); };
  Strain sum = Strain::Zero();
  for (const RimEdge& edge : rim) sum += 0.5 * (moved(edge.a) + moved(edge.b)) * edge.outward.transpose();
  return sum / area;
}

}  // namespace

Moduli stretched_moduli(Index n, Pattern pattern, Mode mode, double angle_degrees) {
  const SheetShape shape{n, n, 1.0 / n};
  Scene scene = make_sheet(shape, pattern, mode);
  const std::vector<RimEdge> rim = rim_of(scene);
  const double angle = angle_degrees * std::numbers::pi / 180.0;
  const Plane along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
  const double stress = wanted_strain * study_material.modulus;
  scene.effects.emplace_back(rim_forces(shape, rim, stress * along * along.transpose()));
  // Nothing holds the sheet: what rounding makes it drift with is braked.
  scene.effects.emplace_back(Drag{study_material.areal_density * shape.cell * shape.cell});
  const Strain strain = mean_gradient(scene, rim, equilibrium(scene, long_step, still), 1.0);
  const double longer = along.dot(strain * along), narrower = -across.dot(strain * across);
  return {stress / longer, narrower / longer};
}

double relative_sag(Index n, Pattern pattern, Mode mode) {
  const SheetShape shape{n / 4, n, 1.0 / n};
  Scene scene = make_sheet(shape, pattern, mode);
  for (Index i = 0; i <= shape.columns; ++i) scene.pin(shape.particle(i, 0));
  const double length = shape.height();
  const double g = wanted_strain * 2.0 * study_material.modulus / (study_material.areal_density * length);
  scene.effects.emplace_back(Gravity{{0.0, -g, 0.0}});
  const std::vector<Vec3> now = equilibrium(scene, long_step, still);
  double sag = 0.0;
  for (Index i = 0; i <= shape.columns; ++i) {
    const Index end = shape.particle(i, shape.rows);
    sag += (scene.particles.position[end].y() - now[end].y()) / (shape.columns + 1.0);
  }
  return sag / (wanted_strain * length);
}

}  // namespace hooke::bench
