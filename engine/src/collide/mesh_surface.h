#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include <hooke/shapes.h>

#include "collide/closest_on_triangle.h"
#include "collide/seen_surface.h"
#include "collide/triangle_tree.h"

namespace hooke {

/// A triangle of a closed surface, with the normal of each of its parts: of edges and corners the sum of
/// those of the triangles there, by their angles. Their sides tell inside from outside wherever the nearest
/// point lies (Baerentzen, Aanaes 2005, "Signed distance computation using the angle weighted pseudonormal").
template <class Real>
struct SurfaceTriangle {
  using Vector = Eigen::Matrix<Real, 3, 1>;

  Vector a, b, c;                 ///< [m]
  std::array<Vector, 7> normals;  ///< of its TrianglePart; unit vectors
  Real offset;                    ///< of the face along its normal [m]

  ClosestOnTriangle<Real> closest_to(const Vector& p) const { return closest_on_triangle<Real>(p, a, b, c); }

  Real distance_to_plane(const Vector& p) const {
    return normals[std::size_t(TrianglePart::face)].dot(p) - offset;
  }

  /// From a point above or below it to the planes upright on its sides.
  Real distance_to_sides(const Vector& p) const {
    const Vector& normal = normals[std::size_t(TrianglePart::face)];
    const auto to_side = [&](const Vector& from, const Vector& to) {
      const Vector across = normal.cross(to - from);
      return across.dot(p - from) / across.norm();
    };
    return std::min({to_side(a, b), to_side(b, c), to_side(c, a)});
  }

  /// What p sees where this is its nearest point; holds for p alone.
  SeenSurface<Real> seen_from(const ClosestOnTriangle<Real>& closest, const Vector& p) const {
    const Vector& normal = normals[std::size_t(closest.part)];
    if (closest.part == TrianglePart::face) return {normal, offset, Real(0)};
    const Real side = (p - closest.point).dot(normal) < Real(0) ? Real(-1) : Real(1);
    return seen_from_edge<Real>(closest.point, normal, side, p);
  }
};

/// A mesh of vertices at different places, around the middle of the box around it.
struct WeldedSurface {
  std::vector<Vec3> vertices;       ///< [m]
  std::vector<Triangle> triangles;  ///< none has a corner twice
  std::vector<Index> numbers;       ///< of `triangles` in the mesh
};

/// Triangles that welding leaves with less than three corners are left out.
WeldedSurface welded_surface(const MeshShape& mesh);

std::vector<TriangleCorners> corners_of(const WeldedSurface& surface);

/// The box around a mesh [m].
Eigen::AlignedBox3d box_around(const MeshShape& mesh);

/// Its triangles with their normals.
template <class Real>
std::vector<SurfaceTriangle<Real>> surface_triangles(const WeldedSurface& surface);

}  // namespace hooke
