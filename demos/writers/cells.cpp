#include "writers/cells.h"

#include <numeric>

namespace hooke {

Cells cells_of(const Scene& scene) {
  Cells cells;
  if (!scene.triangles.empty()) {
    cells.kind = Cells::Kind::triangles;
    cells.corners.reserve(3 * scene.triangles.size());
    for (const Triangle& triangle : scene.triangles) {
      cells.corners.insert(cells.corners.end(), triangle.begin(), triangle.end());
    }
  } else if (scene.springs.size() > 0) {
    cells.kind = Cells::Kind::lines;
    cells.corners.reserve(2 * scene.springs.size());
    for (std::size_t s = 0; s < scene.springs.size(); ++s) {
      cells.corners.push_back(scene.springs.first[s]);
      cells.corners.push_back(scene.springs.second[s]);
    }
  } else {
    cells.corners.resize(scene.particles.size());
    std::iota(cells.corners.begin(), cells.corners.end(), Index{0});
  }
  return cells;
}

}  // namespace hooke
