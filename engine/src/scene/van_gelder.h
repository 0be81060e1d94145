#pragma once

#include <vector>

#include <hooke/materials.h>

#include "scene/mesh_edges.h"

namespace hooke {

/// A spring between two particles of a mesh, whose rest length is their distance.
struct MeshSpring {
  Edge ends;
  double stiffness;  ///< [N/m]
  double damping;    ///< [N s/m]
};

/// The springs of Van Gelder 1998 along the edges of triangles, sorted by their ends: see CalibratedSprings.
/// Throws SceneError where an edge's stiffness comes out negative, which takes an obtuse triangle.
std::vector<MeshSpring> van_gelder_springs(const std::vector<Triangle>& triangles,
                                           const std::vector<Vec3>& positions, const SheetMaterial& sheet);

}  // namespace hooke
