#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <hooke/scene.h>
#include <hooke/simulation.h>

/// Scene files: a scene and how to simulate it, as JSON. The format is described in docs/scenes.md.

namespace hooke {

/// What a scene file says.
struct SceneFile {
  Scene scene;
  Settings settings;
  double seconds = 5.0;  ///< [s] of simulated time to run, > 0
  double fps = 30.0;     ///< [1/s] frames to write for each simulated second, > 0
  std::string description;
};

/// What the reader of a scene file may add to it.
struct SceneFileOptions {
  std::filesystem::path mesh{};  ///< read instead of the file of every cloth_mesh, if not empty

  /// Most particles, in all, that a file may ask for. A short file can name a very large grid: this is
  /// checked before anything of that size is allocated.
  std::size_t max_particles = 100'000'000;
};

/// Thrown where a scene file cannot be used. what() lists the first faults and counts the rest. The element
/// of a fault is its place in the file, such as "effects.drag.coefficient".
class SceneFileError : public std::runtime_error {
 public:
  SceneFileError(std::string_view file, std::vector<Fault> faults);
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

/// Reads a scene file. Meshes named by a relative path are looked for beside it. Throws SceneFileError with
/// every fault that was found.
SceneFile read_scene_file(const std::filesystem::path& file, const SceneFileOptions& options = {});

/// Likewise for the text of a scene file; meshes named by a relative path are looked for in `folder`.
SceneFile parse_scene(std::string_view json, const std::filesystem::path& folder = {},
                      const SceneFileOptions& options = {});

/// The text of a scene file that says the same, particle by particle and spring by spring: reading it gives
/// the same bits. The threads and the executor are not written: they are the machine's. Throws SceneFileError
/// where a file cannot say the same: a force field (its callback is code) or a scene with faults.
std::string write_scene(const SceneFile& file);

}  // namespace hooke
