#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <hooke/stability.h>

#include "scene_file/scene_file.h"

using namespace hooke;
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> shipped_scenes() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(HOOKE_SCENES)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The mesh that a shipped scene is for; empty where it needs none.
fs::path mesh_of(const fs::path& scene) {
  const fs::path data = HOOKE_MESHES;
  if (scene.stem() == "mesh_cloth") return data / "square26K.obj";
  if (scene.stem() == "skirt" || scene.stem() == "windy_skirt") return data / "skirt32K.obj";
  return {};
}

}  // namespace

TEST_CASE("every shipped scene is read, and its step is well within the stable ones") {
  const std::vector<fs::path> files = shipped_scenes();
  CHECK(files.size() >= 10);
  for (const fs::path& file : files) {
    CAPTURE(file.filename().string());
    const fs::path mesh = mesh_of(file);
    if (!mesh.empty() && !fs::exists(mesh)) {
      MESSAGE("skipped " << file.filename().string() << ": there is no " << mesh.filename().string());
      continue;
    }
    SceneFile scene;
    REQUIRE_NOTHROW(scene = read_scene_file(file, {.mesh = mesh}));
    CHECK(!scene.scene.name.empty());
    CHECK(!scene.description.empty());
    CHECK(scene.scene.pins.size() < scene.scene.particles.size());
    CHECK(stability_number(scene.scene, 1.5 * scene.settings.step) < 4.0);
  }
}

TEST_CASE("a shipped mesh scene without its mesh says how to name one") {
  for (const char* name : {"mesh_cloth.json", "skirt.json", "windy_skirt.json"}) {
    CHECK_THROWS_WITH_AS(read_scene_file(fs::path(HOOKE_SCENES) / name), doctest::Contains("--mesh FILE.obj"),
                         SceneFileError);
  }
}
