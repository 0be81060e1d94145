#pragma once

#include <cstddef>
#include <vector>

#include <hooke/scene.h>

namespace hooke {

/// What a scene is drawn with: its triangles, or its springs where it has none, or else its particles.
struct Cells {
  enum class Kind { points = 1, lines = 2, triangles = 3 };  ///< the value is the number of corners

  Kind kind = Kind::points;
  std::vector<Index> corners;  ///< of one cell after the other

  std::size_t corners_of_each() const { return static_cast<std::size_t>(kind); }
  std::size_t size() const { return corners.size() / corners_of_each(); }
};

Cells cells_of(const Scene& scene);

}  // namespace hooke
