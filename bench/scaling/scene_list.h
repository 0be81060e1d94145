#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench_scenes.h"

namespace hooke::bench {

/// A scene that can be made when its turn comes.
struct ListedScene {
  std::string name;
  double particles = 0.0;  ///< roughly
  std::function<BenchScene()> make;
};

/// The irregular meshes by the names that the command line uses.
std::vector<std::string> mesh_names();

/// The cloths of n x n particles, then the meshes. A mesh whose file is absent is left out, with a message on
/// standard error.
std::vector<ListedScene> list_scenes(const std::vector<Index>& sizes, const std::vector<std::string>& meshes);

}  // namespace hooke::bench
