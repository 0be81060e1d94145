#include "picture/framing.h"

#include <algorithm>
#include <limits>

#include "picture/light_direction.h"

namespace hooke::picture {
namespace {

/// A plane of all x with unit `normal` . x = `height` [m].
struct Plane {
  Vec3 normal;
  double height;
};

std::vector<Plane> planes_of(const Subject& subject, const Look& look, const Bounds& bounds) {
  std::vector<Plane> planes;
  for (const GroundPlane& ground : subject.grounds)
    planes.push_back({ground.normal.normalized(), ground.height});
  if (planes.empty()) {
    planes.push_back({subject.up, look.floor_height.value_or(floor_under(bounds, subject.up))});
  }
  return planes;
}

}  // namespace

double floor_under(const Bounds& bounds, const Vec3& up) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vec3& corner : bounds.corners()) lowest = std::min(lowest, corner.dot(up));
  constexpr double under_one_point = 0.02;  // [m], as that is seen from a distance of 1 m
  return lowest - (bounds.diagonal() > 0.0 ? 0.03 * bounds.diagonal() : under_one_point);
}

std::vector<float> with_shadows(std::span<const float> points, const Subject& subject, const Look& look,
                                std::optional<double> reach) {
  std::vector<float> all(points.begin(), points.end());
  if (!look.ground || !look.shadow) return all;
  const Bounds bounds = bounds_of(points);
  const double furthest = reach.value_or(1.5 * bounds.diagonal());
  const Vec3 to_light = direction_to_light(subject.up);
  for (const Plane& plane : planes_of(subject, look, bounds)) {
    const double approach = plane.normal.dot(to_light);
    if (approach <= 0.0) continue;
    for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
      const Vec3 point(points[i], points[i + 1], points[i + 2]);
      const double way = (plane.normal.dot(point) - plane.height) / approach;
      if (!(way > 0.0 && way <= furthest)) continue;
      const Eigen::Vector3f shadow = (point - way * to_light).cast<float>();
      all.insert(all.end(), shadow.data(), shadow.data() + 3);
    }
  }
  return all;
}

}  // namespace hooke::picture
