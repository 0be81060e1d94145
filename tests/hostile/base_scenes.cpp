#include "hostile/base_scenes.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace hooke::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int columns = 6;
constexpr int vertices_along = 5;

void shrink(Json& scene) {
  if (scene.contains("cloth_grid")) {
    scene["cloth_grid"].update({{"columns", columns}, {"rows", columns}});
    if (scene.contains("pins")) {
      for (Json& pin : scene["pins"]) {
        if (pin.contains("cloth_grid")) pin["at"][0] = std::min(pin["at"][0].get<int>(), columns - 1);
      }
    }
  }
  if (scene.contains("block")) scene["block"].update({{"nx", 3}, {"ny", 3}, {"nz", 3}});
  if (scene.contains("cloth_mesh")) scene["cloth_mesh"]["file"] = "mesh.obj";
}

}  // namespace

std::vector<Json> small_scenes() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(HOOKE_SCENES)) files.push_back(entry.path());
  std::sort(files.begin(),
            files.end());  // a folder has no order, and the seeds must mean the same everywhere
  std::vector<Json> scenes;
  for (const fs::path& file : files) {
    if (file.extension() != ".json") continue;
    scenes.push_back(Json::parse(std::ifstream(file)));
    shrink(scenes.back());
  }
  return scenes;
}

std::string small_mesh() {
  std::string text = "# a sheet\nmtllib none.mtl\no sheet\n";
  for (int row = 0; row < vertices_along; ++row) {
    for (int column = 0; column < vertices_along; ++column)
      text += "v " + std::to_string(0.1 * column) + " 0.0 " + std::to_string(0.1 * row) + "\n";
  }
  text += "vn 0 1 0\nvt 0.5 0.5\ng\n";
  for (int row = 0; row + 1 < vertices_along; ++row) {
    for (int column = 0; column + 1 < vertices_along; ++column) {
      const std::string first = std::to_string(row * vertices_along + column + 1);
      const std::string below = std::to_string((row + 1) * vertices_along + column + 1);
      const std::string right = std::to_string(row * vertices_along + column + 2);
      text += "f " + first + "/1/1 " + right + "/1/1 " + below + "/1/1\n";
      text +=
          "f " + right + " " + below + " " + std::to_string((row + 1) * vertices_along + column + 2) + "\n";
    }
  }
  return text;
}

}  // namespace hooke::test
