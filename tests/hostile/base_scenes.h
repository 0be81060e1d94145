#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace hooke::test {

/// The shipped scenes, made small so that thousands of them can be simulated. A cloth from a mesh reads
/// "mesh.obj".
std::vector<nlohmann::json> small_scenes();

/// A sheet of 5 x 5 vertices as an OBJ file, with what such files have besides vertices and faces.
std::string small_mesh();

}  // namespace hooke::test
