#include "scene_file/mesh_file.h"

#include <tiny_obj_loader.h>

#include <cstdint>
#include <string>

namespace hooke {
namespace {

/// What the OBJ reader calls while it goes through a file. Its own triangulation is not used: it takes
/// quadratic time on a face of many corners, and it trusts the indices.
struct MeshBuilder {
  MeshFile mesh;
  std::size_t max_vertices = 0;
  std::size_t faces = 0;
  Index highest = 0;  ///< largest number of a vertex in a face, counted from 1
  std::size_t highest_in_face = 0;

  void vertex(double x, double y, double z) {
    if (mesh.vertices.size() == max_vertices)
      throw FileFault{"has more than " + std::to_string(max_vertices) + " vertices", "give a smaller mesh"};
    const Vec3 position(x, y, z);
    if (!position.allFinite())
      throw FileFault{"vertex " + std::to_string(mesh.vertices.size() + 1) + " is not finite",
                      "correct its v line"};
    mesh.vertices.push_back(position);
  }

  void face(const tinyobj::index_t* corners, int count) {
    ++faces;
    if (count < 3)
      throw FileFault{"face " + std::to_string(faces) + " has " + std::to_string(count) + " corners",
                      "give it at least 3"};
    const Index hub = corner(corners[0].vertex_index);
    Index last = corner(corners[1].vertex_index);
    for (int i = 2; i < count; ++i) {
      const Index next = corner(corners[i].vertex_index);
      mesh.triangles.push_back({hub, last, next});
      last = next;
    }
  }

  /// OBJ counts vertices from 1, or, with negative numbers, back from the newest.
  Index corner(int number) {
    const std::int64_t one_based =
        number < 0 ? static_cast<std::int64_t>(mesh.vertices.size()) + number + 1 : number;
    if (one_based < 1)
      throw FileFault{"face " + std::to_string(faces) + " names vertex " + std::to_string(number),
                      "OBJ files count vertices from 1, or back from -1"};
    const Index found = static_cast<Index>(one_based);
    if (found > highest) {
      highest = found;
      highest_in_face = faces;
    }
    return found - 1;
  }
};

/// A face may come before its vertices, so this is known only at the end.
void check_indices(const MeshBuilder& builder) {
  const std::size_t vertices = builder.mesh.vertices.size();
  if (builder.mesh.triangles.empty())
    throw FileFault{"has no faces (and " + std::to_string(vertices) + " vertices)",
                    "give a Wavefront OBJ file of triangles"};
  if (builder.highest > vertices)
    throw FileFault{"face " + std::to_string(builder.highest_in_face) + " names vertex " +
                        std::to_string(builder.highest) + ", but there are " + std::to_string(vertices),
                    "correct the face, or add the vertex"};
}

}  // namespace

MeshFile read_mesh(std::istream& obj, std::size_t max_vertices) {
  MeshBuilder builder;
  builder.max_vertices = max_vertices;
  tinyobj::callback_t calls;
  calls.vertex_cb = [](void* user, tinyobj::real_t x, tinyobj::real_t y, tinyobj::real_t z, tinyobj::real_t) {
    static_cast<MeshBuilder*>(user)->vertex(x, y, z);
  };
  calls.index_cb = [](void* user, tinyobj::index_t* corners, int count) {
    static_cast<MeshBuilder*>(user)->face(corners, count);
  };
  tinyobj::LoadObjWithCallback(obj, calls, &builder);
  check_indices(builder);
  return std::move(builder.mesh);
}

MeshFile read_mesh_file(const std::filesystem::path& file, std::size_t max_vertices) {
  std::ifstream stream = open_input_file(file);
  return read_mesh(stream, max_vertices);
}

}  // namespace hooke
