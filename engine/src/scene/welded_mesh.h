#pragma once

#include <vector>

#include <hooke/builders.h>

namespace hooke {

/// A mesh with its seams closed and without triangles and vertices that carry no mass. Its particles are
/// numbered from 0 in the order of the vertices they stand at.
struct WeldedMesh {
  MeshParticles particles;
  std::vector<Index> vertices;      ///< of the user's mesh, at which each particle stands
  std::vector<Triangle> triangles;  ///< of particles
  std::vector<double> areas;        ///< of `triangles` [m^2], in the mesh's own size, > 0
};

/// Vertices must be finite and the triangles' corners in range.
WeldedMesh weld_mesh(const ClothMesh& cloth);

}  // namespace hooke
