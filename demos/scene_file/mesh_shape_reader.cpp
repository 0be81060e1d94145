#include <string>
#include <utility>

#include "scene_file/fault_place.h"
#include "scene_file/json_reader.h"
#include "scene_file/mesh_file.h"

namespace hooke {

void JsonReader::read(const Json& value, MeshShape& out) {
  read<MeshShape>(value, out, {"file"});
  if (!value.is_object() || !value.contains("file")) return;
  const At at(*this, "file");
  if (value.contains("vertices") || value.contains("triangles"))
    return fault("is given beside vertices or triangles", "give one of the two");
  std::string named;
  read(value["file"], named);
  if (named.empty()) return;
  const std::filesystem::path file = folder_ / named;
  try {
    MeshFile mesh = read_mesh_file(file, most_vertices_);
    out.vertices = std::move(mesh.vertices);
    out.triangles = std::move(mesh.triangles);
  } catch (const FileFault& wrong) {
    fault("mesh " + printable(file.string()) + " " + wrong.problem, wrong.remedy);
  }
}

}  // namespace hooke
