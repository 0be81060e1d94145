#include "collide/mesh_surface.h"

#include <cmath>
#include <map>
#include <utility>

#include "scene/weld.h"

namespace hooke {
namespace {

Vec3 unit_or_zero(const Vec3& a) {
  const double length = a.stableNorm();
  return length > 0.0 ? Vec3(a / length) : Vec3(Vec3::Zero());
}

Vec3 face_normal(const WeldedSurface& surface, const Triangle& t) {
  const auto& x = surface.vertices;
  return unit_or_zero((x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]));
}

/// Between the two sides at a corner of a triangle [rad].
double angle_at(const WeldedSurface& surface, const Triangle& t, std::size_t corner) {
  const auto& x = surface.vertices;
  const Vec3 first = x[t[(corner + 1) % 3]] - x[t[corner]], second = x[t[(corner + 2) % 3]] - x[t[corner]];
  return std::atan2(first.cross(second).norm(), first.dot(second));
}

using Edge = std::pair<Index, Index>;

Edge edge_from(const Triangle& t, std::size_t corner) {
  return std::minmax({t[corner], t[(corner + 1) % 3]});
}

/// The sums of the normals around each edge and corner.
struct NormalSums {
  std::map<Edge, Vec3> edges;
  std::vector<Vec3> corners;

  explicit NormalSums(const WeldedSurface& surface) : corners(surface.vertices.size(), Vec3::Zero()) {
    for (const Triangle& t : surface.triangles) {
      const Vec3 normal = face_normal(surface, t);
      for (std::size_t corner = 0; corner < 3; ++corner) {
        corners[t[corner]] += angle_at(surface, t, corner) * normal;
        edges.try_emplace(edge_from(t, corner), Vec3::Zero()).first->second += normal;
      }
    }
  }
};

}  // namespace

Eigen::AlignedBox3d box_around(const MeshShape& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& vertex : mesh.vertices) box.extend(mesh.scale * vertex);
  return box;
}

WeldedSurface welded_surface(const MeshShape& mesh) {
  const std::vector<Index> stands_for = weld(mesh.vertices, 0.0);
  const Vec3 middle = box_around(mesh).center();
  WeldedSurface surface;
  surface.vertices.reserve(mesh.vertices.size());
  for (const Vec3& vertex : mesh.vertices) surface.vertices.push_back(mesh.scale * vertex - middle);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Triangle welded{stands_for[a], stands_for[b], stands_for[c]};
    if (welded[0] == welded[1] || welded[1] == welded[2] || welded[2] == welded[0]) continue;
    surface.triangles.push_back(welded);
    surface.numbers.push_back(Index(i));
  }
  return surface;
}

std::vector<TriangleCorners> corners_of(const WeldedSurface& surface) {
  std::vector<TriangleCorners> corners;
  corners.reserve(surface.triangles.size());
  for (const auto& [a, b, c] : surface.triangles)
    corners.push_back({surface.vertices[a], surface.vertices[b], surface.vertices[c]});
  return corners;
}

template <class Real>
std::vector<SurfaceTriangle<Real>> surface_triangles(const WeldedSurface& surface) {
  const NormalSums sums(surface);
  const auto& x = surface.vertices;
  std::vector<SurfaceTriangle<Real>> triangles;
  triangles.reserve(surface.triangles.size());
  for (const Triangle& t : surface.triangles) {
    const Vec3 normal = face_normal(surface, t);
    SurfaceTriangle<Real> triangle{
        x[t[0]].cast<Real>(), x[t[1]].cast<Real>(), x[t[2]].cast<Real>(), {}, Real(normal.dot(x[t[0]]))};
    triangle.normals[std::size_t(TrianglePart::face)] = normal.cast<Real>();
    for (std::size_t corner = 0; corner < 3; ++corner) {
      triangle.normals[std::size_t(TrianglePart::edge_a) + corner] =
          unit_or_zero(sums.edges.at(edge_from(t, corner))).cast<Real>();
      triangle.normals[std::size_t(TrianglePart::corner_a) + corner] =
          unit_or_zero(sums.corners[t[corner]]).cast<Real>();
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

template std::vector<SurfaceTriangle<float>> surface_triangles(const WeldedSurface&);
template std::vector<SurfaceTriangle<double>> surface_triangles(const WeldedSurface&);

}  // namespace hooke
