#pragma once

#include <filesystem>
#include <map>
#include <string_view>
#include <variant>
#include <vector>

#include <hooke/builders.h>

#include "scene_file/json_reader.h"
#include "scene_file/scene_file.h"

/// The builders of a scene file: cloths, ropes and blocks that are made from a few numbers.

namespace hooke {

/// Every builder, in the order in which a file's builders add to the scene.
using Builder = std::variant<ClothGrid, ClothMesh, Rope, Block>;

/// What one builder added to the scene.
struct Part {
  Index first = 0, count = 0;  ///< its particles
  std::vector<Index> shape;  ///< particles along each direction, the first running fastest; empty for a mesh

  bool has_grid() const { return !shape.empty(); }
};

/// The parts of each kind of builder, by its name, in the order of the file.
using Parts = std::map<std::string_view, std::vector<Part>>;

/// Adds what the builders of the file make to the scene.
Parts read_builders(JsonReader& reader, const Json& root, const std::filesystem::path& folder,
                    const SceneFileOptions& options, Scene& scene);

}  // namespace hooke
