#pragma once

#include "scene_file/json_reader.h"

/// Particles, springs and triangles that a scene file lists one by one.

namespace hooke {

/// Reads "particles" of the file into an empty scene.
void read_particles(JsonReader& reader, const Json& root, std::size_t max_particles, Particles& particles);

/// Adds "springs" and "triangles" of the file. They may name any particle of the scene, so builders come
/// first.
void read_springs(JsonReader& reader, const Json& root, Scene& scene);
void read_triangles(JsonReader& reader, const Json& root, Scene& scene);

}  // namespace hooke
