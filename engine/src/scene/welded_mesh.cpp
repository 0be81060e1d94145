#include "scene/welded_mesh.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "scene/weld.h"

namespace hooke {
namespace {

/// [m^2]; zero also where the corners lie on a line up to rounding: such a triangle has no width, only noise.
double area_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  const double twice = (b - a).cross(c - a).norm();
  return twice > 1e-12 * longest ? 0.5 * twice : 0.0;
}

/// Fills in the triangles that have an area, still between vertices, and counts the others.
void keep_triangles(const ClothMesh& cloth, const std::vector<Index>& stands_for, WeldedMesh& mesh) {
  mesh.triangles.reserve(cloth.triangles.size());
  mesh.areas.reserve(cloth.triangles.size());
  for (const auto& [a, b, c] : cloth.triangles) {
    const Triangle triangle{stands_for[a], stands_for[b], stands_for[c]};
    const double area =
        area_of(cloth.vertices[triangle[0]], cloth.vertices[triangle[1]], cloth.vertices[triangle[2]]);
    if (area > 0.0) {
      mesh.triangles.push_back(triangle);
      mesh.areas.push_back(area);
    } else {
      ++mesh.particles.degenerate_triangles;
    }
  }
}

/// Makes a particle of each vertex that a triangle stands on and of those welded to it.
void number_particles(const std::vector<Index>& stands_for, WeldedMesh& mesh) {
  constexpr Index none = MeshParticles::none;
  MeshParticles& particles = mesh.particles;
  std::vector<bool> used(stands_for.size(), false);
  for (const Triangle& triangle : mesh.triangles) {
    for (const Index vertex : triangle) used[vertex] = true;
  }
  particles.of_vertex.assign(stands_for.size(), none);
  for (Index vertex = 0; vertex < stands_for.size(); ++vertex) {
    const Index representative = stands_for[vertex];  // never after `vertex`, so it has its number
    if (!used[representative]) {
      ++particles.unused_vertices;
    } else if (representative != vertex) {
      particles.of_vertex[vertex] = particles.of_vertex[representative];
      ++particles.welded_vertices;
    } else {
      particles.of_vertex[vertex] = particles.count++;
      mesh.vertices.push_back(vertex);
    }
  }
}

}  // namespace

WeldedMesh weld_mesh(const ClothMesh& cloth) {
  const std::vector<Index> stands_for = weld(cloth.vertices, cloth.weld_tolerance);
  WeldedMesh mesh;
  keep_triangles(cloth, stands_for, mesh);
  number_particles(stands_for, mesh);
  for (Triangle& triangle : mesh.triangles) {
    for (Index& corner : triangle) corner = mesh.particles.of_vertex[corner];
  }
  return mesh;
}

}  // namespace hooke
