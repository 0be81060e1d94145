#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include <hooke/shapes.h>

#include "sphere_scene.h"

namespace hooke::test {

/// A prism over a polygon in the plane of x and y, anticlockwise, whose corners all see the first one.
inline MeshShape prism_mesh(const std::vector<std::array<double, 2>>& outline, double low, double high) {
  MeshShape mesh;
  const auto count = Index(outline.size());
  for (const double z : {low, high}) {
    for (const auto& [x, y] : outline) mesh.vertices.emplace_back(x, y, z);
  }
  for (Index i = 1; i + 1 < count; ++i) {
    mesh.triangles.push_back({0, i + 1, i});
    mesh.triangles.push_back({count, count + i, count + i + 1});
  }
  for (Index i = 0; i < count; ++i) {
    const Index next = (i + 1) % count;
    mesh.triangles.push_back({i, next, count + next});
    mesh.triangles.push_back({i, count + next, count + i});
  }
  return mesh;
}

inline MeshShape box_mesh(const Vec3& half) {
  return prism_mesh(
      {{-half.x(), -half.y()}, {half.x(), -half.y()}, {half.x(), half.y()}, {-half.x(), half.y()}}, -half.z(),
      half.z());
}

/// An angle of iron: edges that point in and out.
inline MeshShape angle_mesh() {
  return prism_mesh({{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.3}, {0.25, 0.2}, {0.2, 0.9}, {0.0, 1.0}}, -0.3, 0.5);
}

/// A ball with bumps and hollows.
inline MeshShape bumpy_mesh(int times) {
  const Scene sphere = sphere_scene(times, 1.0, 0.0);
  MeshShape mesh;
  for (const Vec3& x : sphere.particles.position)
    mesh.vertices.push_back((0.5 + 0.1 * std::sin(7.0 * x.x()) * std::sin(5.0 * x.y() + 1.0)) * x);
  mesh.triangles = sphere.triangles;
  return mesh;
}

/// How often a closed mesh goes around a point: 1 inside, 0 outside (van Oosterom, Strackee 1983).
inline double winding_number(const MeshShape& mesh, const Vec3& point) {
  double sum = 0.0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vec3 a = mesh.scale * mesh.vertices[i] - point, b = mesh.scale * mesh.vertices[j] - point,
               c = mesh.scale * mesh.vertices[k] - point;
    const double x = a.norm(), y = b.norm(), z = c.norm();
    sum += std::atan2(a.dot(b.cross(c)), x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
  }
  return sum / (2.0 * M_PI);
}

/// How far a point is from a triangle, as the least over its inside and its sides.
inline double distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
    const double t = std::clamp((p - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - from - t * (to - from)).norm());
  }
  const Vec3 normal = (b - a).cross(c - a).normalized();
  const Vec3 foot = p - normal.dot(p - a) * normal;
  const bool is_over = normal.dot((b - a).cross(foot - a)) > 0.0 &&
                       normal.dot((c - b).cross(foot - b)) > 0.0 && normal.dot((a - c).cross(foot - c)) > 0.0;
  return is_over ? std::abs(normal.dot(p - a)) : least;
}

/// Of a mesh, by looking at all its triangles [m], negative inside.
inline double distance_to_mesh(const MeshShape& mesh, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [i, j, k] : mesh.triangles)
    least =
        std::min(least, distance_to_triangle(p, mesh.scale * mesh.vertices[i], mesh.scale * mesh.vertices[j],
                                             mesh.scale * mesh.vertices[k]));
  return winding_number(mesh, p) > 0.5 ? -least : least;
}

/// The same solid as a heightfield's, as a closed mesh.
inline MeshShape mesh_of(const HeightfieldShape& field) {
  MeshShape mesh;
  const Index n = field.columns, m = field.rows, top = n * m;
  double lowest = std::numeric_limits<double>::infinity();
  for (const double height : field.heights) lowest = std::min(lowest, height);
  for (const bool is_top : {true, false}) {
    for (Index j = 0; j < m; ++j) {
      for (Index i = 0; i < n; ++i)
        mesh.vertices.push_back(field.corner + Vec3(field.spacing * i,
                                                    is_top ? field.heights[j * n + i] : lowest - field.depth,
                                                    field.spacing * j));
    }
  }
  for (Index j = 0; j + 1 < m; ++j) {
    for (Index i = 0; i + 1 < n; ++i) {
      const Index a = j * n + i, b = a + 1, d = a + n, c = d + 1;
      mesh.triangles.insert(mesh.triangles.end(), {{a, c, b}, {a, d, c}});
      mesh.triangles.insert(mesh.triangles.end(), {{top + a, top + b, top + c}, {top + a, top + c, top + d}});
    }
  }
  std::vector<Index> rim;  // anticlockwise from above
  for (Index j = 0; j < m; ++j) rim.push_back(j * n);
  for (Index i = 1; i < n; ++i) rim.push_back((m - 1) * n + i);
  for (Index j = m - 1; j-- > 0;) rim.push_back(j * n + n - 1);
  for (Index i = n - 1; i-- > 1;) rim.push_back(i);
  for (std::size_t k = 0; k < rim.size(); ++k) {
    const Index a = rim[k], b = rim[(k + 1) % rim.size()];
    mesh.triangles.insert(mesh.triangles.end(), {{a, top + a, top + b}, {a, top + b, b}});
  }
  return mesh;
}

}  // namespace hooke::test
