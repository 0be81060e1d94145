#include "scene_file/builder_reader.h"

#include <optional>
#include <string>
#include <utility>

#include "scene_file/fault_place.h"
#include "scene_file/mesh_file.h"

namespace hooke {
namespace {

/// As doubles, because the counts of wrong numbers fit into no integer.
double particles_of(const ClothGrid& cloth) {
  return static_cast<double>(cloth.columns) * cloth.rows;
}
double particles_of(const ClothMesh& cloth) {
  return static_cast<double>(cloth.vertices.size());
}
double particles_of(const Rope& rope) {
  return rope.particles;
}
double particles_of(const Block& block) {
  return static_cast<double>(block.nx) * block.ny * block.nz;
}

Part part_of(const GridParticles& grid) {
  return {grid.first, grid.columns * grid.rows, {grid.columns, grid.rows}};
}
Part part_of(const MeshParticles& mesh) {
  return {mesh.first, mesh.count, {}};
}
Part part_of(const RopeParticles& rope) {
  return {rope.first, rope.count, {rope.count}};
}
Part part_of(const BlockParticles& block) {
  return {block.first, block.nx * block.ny * block.nz, {block.nx, block.ny, block.nz}};
}

class BuilderReader {
 public:
  BuilderReader(JsonReader& reader, const std::filesystem::path& folder, const SceneFileOptions& options,
                Scene& scene)
      : reader_(reader), folder_(folder), options_(options), scene_(scene) {}

  template <class T>
  std::vector<Part> read_all(const Json& root) {
    std::vector<Part> parts;
    const auto found = root.find(T::name);
    if (found == root.end()) return parts;
    const JsonReader::At at(reader_, T::name);
    reader_.for_each_entry(*found, [&](const Json& entry) {
      T builder;
      if (const auto part = read(entry, builder) ? build(builder) : std::nullopt) parts.push_back(*part);
    });
    return parts;
  }

 private:
  /// Whether it is worth building; wrong fields have kept their defaults, so that building finds further
  /// faults.
  template <class T>
  bool read(const Json& entry, T& builder) {
    reader_.read(entry, builder);
    return entry.is_object();
  }

  bool read(const Json& entry, ClothMesh& cloth) {
    reader_.read(entry, cloth, {"file"});
    return entry.is_object() && read_mesh(entry, cloth);
  }

  bool read_mesh(const Json& entry, ClothMesh& cloth) {
    const std::size_t before = reader_.faults();
    std::string named;
    reader_.read_optional(entry, "file", named);
    if (reader_.faults() != before) return false;

    const JsonReader::At at(reader_, "file");
    const std::filesystem::path file =
        options_.mesh.empty() && !named.empty() ? folder_ / named : options_.mesh;
    if (file.empty()) {
      reader_.fault("is missing", "name an OBJ file here, or with --mesh FILE.obj");
      return false;
    }
    try {
      MeshFile mesh = read_mesh_file(file, options_.max_particles);
      cloth.vertices = std::move(mesh.vertices);
      cloth.triangles = std::move(mesh.triangles);
      return true;
    } catch (const FileFault& fault) {
      reader_.fault("mesh " + printable(file.string()) + " " + fault.problem,
                    fault.remedy + ", or name another mesh with --mesh FILE.obj");
      return false;
    }
  }

  template <class T>
  std::optional<Part> build(const T& builder) {
    const double wanted = static_cast<double>(scene_.particles.size()) + particles_of(builder);
    if (wanted > static_cast<double>(options_.max_particles)) {
      reader_.fault("makes a scene of " + Json(wanted).dump() + " particles",
                    "make it of at most " + std::to_string(options_.max_particles));
      return std::nullopt;
    }
    try {
      return part_of(add(scene_, builder));
    } catch (const SceneError& error) {
      for (const Fault& found : error.faults()) {
        Fault fault = at_place(found, reader_.place());
        reader_.fault_at(std::move(fault.element), std::move(fault.problem), std::move(fault.remedy));
      }
      return std::nullopt;
    }
  }

  JsonReader& reader_;
  const std::filesystem::path& folder_;
  const SceneFileOptions& options_;
  Scene& scene_;
};

}  // namespace

Parts read_builders(JsonReader& reader, const Json& root, const std::filesystem::path& folder,
                    const SceneFileOptions& options, Scene& scene) {
  BuilderReader builders(reader, folder, options, scene);
  Parts parts;
  for_each_alternative<Builder>([&]<class T>(const T&) { parts[T::name] = builders.read_all<T>(root); });
  return parts;
}

}  // namespace hooke
