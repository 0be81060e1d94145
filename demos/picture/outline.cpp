#include "picture/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hooke::picture {

Outline::Outline(const Camera& camera, double aspect) {
  const double over = std::tan(0.5 * camera.field_of_view), right = over * aspect;
  const auto take = [&](const Vec3& direction) { directions_.push_back(direction.cast<float>()); };
  // Outwards from the borders of what is seen: those of the whole picture, and of less where it has a margin.
  for (const double share : {1.0, 0.9, 0.8}) {
    for (const double sign : {-1.0, 1.0}) {
      take(sign * camera.right() - share * right * camera.forward());
      take(sign * camera.over() - share * over * camera.forward());
    }
  }
  for (const double sign : {-1.0, 1.0}) take(sign * camera.forward());
  reach_.assign(directions_.size(), -std::numeric_limits<float>::infinity());
}

void Outline::add(std::span<const float> points) {
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    const Eigen::Vector3f point(points[i], points[i + 1], points[i + 2]);
    if (!point.allFinite()) continue;
    furthest_.resize(3 * directions_.size());
    for (std::size_t k = 0; k < directions_.size(); ++k) {
      const float reach = directions_[k].dot(point);
      if (!(reach > reach_[k])) continue;
      reach_[k] = reach;
      std::copy_n(point.data(), 3, furthest_.data() + 3 * k);
    }
  }
}

}  // namespace hooke::picture
