#include "scene/scene_size.h"

#include <algorithm>

namespace hooke {

double scene_size(const Scene& scene) {
  double size = 0.0;
  if (scene.particles.size() > 0) {
    Vec3 low = scene.particles.position[0], high = low;
    for (const Vec3& position : scene.particles.position) {
      low = low.cwiseMin(position);
      high = high.cwiseMax(position);
    }
    size = (high - low).stableNorm();
  }
  for (double length : scene.springs.rest_length) size = std::max(size, length);
  return size > 0.0 ? size : 1.0;
}

}  // namespace hooke
