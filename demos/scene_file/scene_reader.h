#pragma once

#include <filesystem>

#include "scene_file/json_reader.h"
#include "scene_file/scene_file.h"

namespace hooke {

/// Reads what a scene file says from its JSON. Faults go to the reader; with any, the result must not be
/// used.
SceneFile read_scene(JsonReader& reader, const Json& root, const std::filesystem::path& folder,
                     const SceneFileOptions& options);

}  // namespace hooke
