#pragma once

#include <Eigen/Core>

namespace hooke::viewer {

/// Where the scene is drawn: a size [pixels], and places in it, from its upper left corner.
struct Viewport {
  double width = 1.0, height = 1.0;

  double aspect() const { return width / height; }

  /// From (-1, -1) at the lower left to (1, 1) at the upper right, as cameras count.
  Eigen::Vector2d place(const Eigen::Vector2d& pixel) const {
    return {2.0 * pixel.x() / width - 1.0, 1.0 - 2.0 * pixel.y() / height};
  }
  Eigen::Vector2d pixel(double x, double y) const {
    return {0.5 * (x + 1.0) * width, 0.5 * (1.0 - y) * height};
  }
};

}  // namespace hooke::viewer
