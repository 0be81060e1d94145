#pragma once

#include "scene_file/builder_reader.h"
#include "scene_file/json_reader.h"

namespace hooke {

/// Adds the pins of the file to a scene that has all its particles. `max_keyframes` limits what the paths of
/// all pinned particles hold together: one long path may be meant for many particles.
void read_pins(JsonReader& reader, const Json& root, const Parts& parts, std::size_t max_keyframes,
               Scene& scene);

}  // namespace hooke
