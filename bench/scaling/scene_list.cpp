#include "scaling/scene_list.h"

#include <filesystem>
#include <iostream>
#include <optional>

namespace hooke::bench {
namespace {

struct JitteredSheet {
  const char* name;
  Index columns, rows;
};
constexpr JitteredSheet jittered_sheets[] = {
    {"jittered10K", 100, 100}, {"jittered100K", 400, 250}, {"jittered1M", 1000, 1000}};

struct MeshOfFile {
  const char* name;
  double particles;
};
constexpr MeshOfFile meshes_of_files[] = {{"square26K", 26e3}, {"skirt32K", 33e3}};

ListedScene square_cloth(Index n) {
  return {"cloth_" + std::to_string(n), double(n) * n, [n] { return cloth(n); }};
}

std::optional<ListedScene> irregular_cloth(const std::string& name) {
  for (const JitteredSheet& sheet : jittered_sheets) {
    if (name != sheet.name) continue;
    return ListedScene{name, double(sheet.columns) * sheet.rows,
                       [sheet] { return jittered_cloth(sheet.name, sheet.columns, sheet.rows); }};
  }
  for (const MeshOfFile& mesh : meshes_of_files) {
    if (name != mesh.name) continue;
    const std::string file = std::string(HOOKE_MESHES) + "/" + name + ".obj";
    if (std::filesystem::exists(file))
      return ListedScene{name, mesh.particles, [name, file] { return mesh_cloth(name, file); }};
    std::cerr << "skipped: " << name << ", as there is no " << file << '\n';
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> mesh_names() {
  std::vector<std::string> names;
  for (const MeshOfFile& mesh : meshes_of_files) names.emplace_back(mesh.name);
  for (const JitteredSheet& sheet : jittered_sheets) names.emplace_back(sheet.name);
  return names;
}

std::vector<ListedScene> list_scenes(const std::vector<Index>& sizes,
                                     const std::vector<std::string>& meshes) {
  std::vector<ListedScene> scenes;
  for (Index n : sizes) scenes.push_back(square_cloth(n));
  for (const std::string& name : meshes) {
    if (auto scene = irregular_cloth(name)) scenes.push_back(std::move(*scene));
  }
  return scenes;
}

}  // namespace hooke::bench
