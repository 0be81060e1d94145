#include "effects/priced_effects.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hooke::bench {
namespace {

/// A flat cloth moves all the time but hardly: its springs at rest cost as much as any.
Scene cloth(Index columns) {
  Scene scene;
  const GridParticles grid = add(scene, ClothGrid{.columns = columns, .rows = columns, .spacing = 0.01});
  scene.pin(grid.at(0, 0));
  scene.pin(grid.at(columns - 1, 0));
  return scene;
}

Scene cube(Index columns) {
  Scene scene;
  const auto side = Index(std::max(3.0, std::cbrt(double(columns) * double(columns))));
  add(scene, Block{.nx = side, .ny = side, .nz = side, .spacing = 0.02});
  return scene;
}

std::vector<Index> all_springs(const Scene& scene) {
  std::vector<Index> springs(scene.springs.size());
  for (std::size_t i = 0; i < springs.size(); ++i) springs[i] = Index(i);
  return springs;
}

/// A tenth of the particles, none of them pinned.
std::vector<Index> some_particles(const Scene& scene) {
  std::vector<Index> particles;
  for (Index i = 5; i < scene.particles.size(); i += 10) {
    const auto is_here = [&](const Pin& pin) { return pin.particle == i; };
    if (std::ranges::none_of(scene.pins, is_here)) particles.push_back(i);
  }
  return particles;
}

/// Each particle with the one after it, which all are drawn together within a day.
Stitch pairs_of(const std::vector<Index>& particles) {
  Stitch stitch{.closing_time = 86400.0};
  for (std::size_t i = 0; i + 1 < particles.size(); i += 2) {
    stitch.first.push_back(particles[i]);
    stitch.second.push_back(particles[i + 1]);
  }
  return stitch;
}

/// Edges that two triangles of a grid of cells share.
double hinges(Index columns) {
  const double cells = double(columns) - 1.0;
  return cells * cells + 2.0 * cells * (cells - 1.0);
}

void add_nothing_much(const ParticleBatch& batch) {
  for (std::size_t i = 0; i < batch.particle.size(); ++i) batch.fy[i] -= 1e-6 * batch.vy[i];
}

}  // namespace

std::vector<PricedEffect> priced_effects(Index columns) {
  const Scene sheet = cloth(columns), body = cube(columns);
  const auto particles = double(sheet.particles.size()), springs = double(sheet.springs.size());
  const auto triangles = double(sheet.triangles.size()), surface = double(body.triangles.size());
  const GridParticles grid{0, columns, columns};
  const LaplacianBending lines = bending_of(grid, 0.01, 1e-6);
  const std::vector<Index> every_spring = all_springs(sheet), some = some_particles(sheet);
  const auto of_some = double(some.size());
  const UniformField air{{1.0, 0.0, 1.0}};
  const TurbulenceField eddies{.amplitude = 1.0};
  const auto spring = std::string("spring"), particle = std::string("particle"),
             triangle = std::string("triangle");
  return {
      {"gravity", sheet, Gravity{}, particle, particles},
      {"drag", sheet, Drag{1e-5}, particle, particles},
      {"field (uniform)", sheet, Field{UniformField{{0.0, 0.0, 1e-6}}}, particle, particles},
      {"field (vortex)", sheet, Field{VortexField{.rate = 1e-6}}, particle, particles},
      {"field (turbulence)", sheet, Field{TurbulenceField{.amplitude = 1e-6}}, particle, particles},
      {"particle_wind (uniform)", sheet, ParticleWind{1e-6, air}, particle, particles},
      {"wind (uniform)", sheet, Wind{air}, triangle, triangles},
      {"wind (turbulence)", sheet, Wind{eddies}, triangle, triangles},
      {"force_script", sheet, ForceScript{some, {{0.0, {0, 0, 0}}, {1e3, {1e-3, 0, 0}}}}, particle, of_some},
      {"ground_plane", sheet, GroundPlane{.height = -100.0}, particle, particles},
      {"hinge_bending", sheet, HingeBending{.stiffness = 1e-6}, "hinge", hinges(columns)},
      {"laplacian_bending", sheet, lines, "triple", double(lines.stiffness.size())},
      {"tensile_triangles", sheet, TensileTriangles{.modulus = 10.0}, triangle, triangles},
      {"cables", sheet, Cables{every_spring}, spring, springs},
      {"stiffening_springs", sheet, StiffeningSprings{.cubic = 1.0}, spring, springs},
      {"plasticity", sheet, Plasticity{.rate = 1.0}, spring, springs},
      {"pressure", body, Pressure{.overpressure = 1.0, .ambient = 10.0}, triangle, surface},
      {"volume", body, Volume{.bulk_modulus = 10.0}, triangle, surface},
      {"custom (parallel)", sheet, CustomEffect{"custom", add_nothing_much, true}, particle, particles},
      {"custom (serial)", sheet, CustomEffect{"custom", add_nothing_much, false}, particle, particles},
      {"strain_limit", sheet, StrainLimit{}, spring, springs},
      {"tethers", sheet, Tethers{.slack = 0.1}, particle, particles},
      {"collider (beside it)", sheet, Collider{.shape = SphereShape{{0.0, 0.0, -2.0}, 0.5}}, particle,
       particles},
      {"collider (it lies on it)", sheet,
       Collider{.shape = PlaneShape{{0.0, 0.0, 1.0}}, .thickness = 1e-5, .friction = 0.3}, particle,
       particles},
      {"collider (a penalty, beside it)", sheet,
       Collider{.shape = SphereShape{{0.0, 0.0, -2.0}, 0.5}, .stiffness = 1e-3}, particle, particles},
      {"collider (a penalty, it lies in it)", sheet,
       Collider{.shape = PlaneShape{{0.0, 0.0, 1.0}},
                .thickness = 1e-5,
                .friction = 0.3,
                .stiffness = 1e-3,
                .damping = 1e-6},
       particle, particles},
      {"frame_attachment", sheet, FrameAttachment{.particles = some}, particle, of_some},
      {"stitch", sheet, pairs_of(some), "pair", of_some / 2.0},
      {"self_collision (nothing near)", sheet, SelfCollision{.thickness = 1e-5}, particle, particles},
      {"particle_contact (nothing near)", sheet, ParticleContact{.radius = {0.001}}, particle, particles},
      {"tearing (nothing torn)", sheet, Tearing{.strain = 10.0}, spring, springs},
      {"sleep (nothing sleeps)", sheet, Sleep{.speed = 1e-12}, particle, particles},
      {"motion_script", sheet, MotionScript{some, {{0.0, {0, 0, 0}}, {1e3, {0.01, 0, 0}}}}, particle,
       of_some},
  };
}

}  // namespace hooke::bench
