#pragma once

#include <cstddef>
#include <filesystem>
#include <istream>
#include <vector>

#include <hooke/scene.h>

#include "scene_file/input_file.h"

/// Triangle meshes from Wavefront OBJ files.

namespace hooke {

struct MeshFile {
  std::vector<Vec3> vertices;       ///< in the file's own unit
  std::vector<Triangle> triangles;  ///< into `vertices`
};

/// Reads the vertices and faces of an OBJ file; everything else in it is passed over. A face of more than
/// three corners becomes a fan of triangles about its first, which is right where the face is convex. Throws
/// FileFault, also for more than `max_vertices`.
MeshFile read_mesh_file(const std::filesystem::path& file, std::size_t max_vertices);

/// Likewise from a stream.
MeshFile read_mesh(std::istream& obj, std::size_t max_vertices);

}  // namespace hooke
