#include "bench_scenes.h"

#include <utility>

#include "jittered_mesh.h"
#include "scene_file/mesh_file.h"

namespace hooke::bench {
namespace {

BenchScene finished(std::string name, Scene scene) {
  scene.effects = {Gravity{{0.0, 0.0, 9.81}}, Drag{.coefficient = 1e-6}};
  const double step = 0.5 * 2.0 / highest_frequency(scene);  // symplectic Euler is stable below 2 / w
  return {std::move(name), std::move(scene), step};
}

BenchScene hung_by_edge(const std::string& name, TriangleMesh mesh, const Vec3& direction) {
  ClothMesh cloth{.stretch = 100.0, .bend = 1.0};
  cloth.vertices = std::move(mesh.vertices);
  cloth.triangles = std::move(mesh.triangles);
  Scene scene;
  const MeshParticles particles = add(scene, cloth);
  for (Index particle : furthest_along(scene, particles.first, particles.count, direction, 0.02))
    scene.pin(particle);
  return finished(name, std::move(scene));
}

}  // namespace

BenchScene cloth(Index n) {
  Scene scene;
  const GridParticles particles = add(scene, ClothGrid{.columns = n,
                                                       .rows = n,
                                                       .spacing = 1.0 / n,
                                                       .areal_density = 0.2,
                                                       .stretch = 100.0,
                                                       .shear = 50.0,
                                                       .bend = 1.0});
  scene.pin(particles.at(0, 0));
  scene.pin(particles.at(n - 1, 0));
  return finished("cloth_" + std::to_string(n), std::move(scene));
}

BenchScene mesh_cloth(const std::string& name, const std::string& file) {
  const MeshFile mesh = read_mesh_file(file, 10'000'000);
  return hung_by_edge(name, {mesh.vertices, mesh.triangles}, Vec3(0, 0, -1));
}

BenchScene jittered_cloth(const std::string& name, Index columns, Index rows) {
  return hung_by_edge(name, jittered_mesh(columns, rows), Vec3(0, 1, 0));
}

}  // namespace hooke::bench
