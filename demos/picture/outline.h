#pragma once

#include <span>
#include <vector>

#include "picture/camera.h"

namespace hooke::picture {

/// The few of very many points that decide where a camera must be to see all of them: those furthest along
/// the borders of what it sees. Points of a movie do not fit in memory all at once.
class Outline {
 public:
  /// For cameras that look like this one, from anywhere, at pictures of `aspect` = width / height.
  Outline(const Camera& camera, double aspect);

  /// Takes x, y, z of each point [m]. Points that are not finite are left out.
  void add(std::span<const float> points);

  /// x, y, z of the points that were furthest [m], some of them several times.
  std::span<const float> points() const { return furthest_; }

 private:
  std::vector<Eigen::Vector3f> directions_;
  std::vector<float> reach_;     ///< of the points so far along each direction [m]
  std::vector<float> furthest_;  ///< x, y, z of the points that reach there
};

}  // namespace hooke::picture
