#pragma once

#include "program/arguments.h"
#include "scene_file/scene_file.h"

namespace hooke::program {

/// Reads the scene that the arguments name, with what they change in it. Throws SceneFileError.
SceneFile read_scene(const Arguments& arguments);

}  // namespace hooke::program
