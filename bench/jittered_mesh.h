#pragma once

#include <cstdint>
#include <vector>

#include <hooke/scene.h>

namespace hooke::bench {

/// Triangles on a flat sheet, counter-clockwise seen from +z.
struct TriangleMesh {
  std::vector<Vec3> vertices;  ///< [m]
  std::vector<Triangle> triangles;
};

/// The Delaunay triangulation of a jittered grid of columns x rows vertices (both >= 2) on a sheet in the x-y
/// plane whose longer side is 1 m: as irregular as a mesh from a tool. Valences vary, and vertices are
/// numbered in random order. Equal arguments give equal meshes on every machine.
TriangleMesh jittered_mesh(Index columns, Index rows, std::uint64_t seed = 1);

}  // namespace hooke::bench
