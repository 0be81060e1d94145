#include "viewer/picking.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hooke::viewer {
namespace {

struct Candidate {
  Index particle;
  double distance;  // [pixels] on the screen
  double depth;     // [m]
};

/// Projects many points: what Camera::project() works out for each is worked out once.
class Projector {
 public:
  Projector(const picture::Camera& camera, const Viewport& viewport)
      : eye_(camera.eye()),
        forward_(camera.forward()),
        pixels_(0.5 * viewport.height / std::tan(0.5 * camera.field_of_view)),
        right_(pixels_ * camera.right()),
        down_(-pixels_ * camera.over()),
        middle_(0.5 * viewport.width, 0.5 * viewport.height) {}

  /// Depth [m]; `pixel` is set where that is positive.
  double project(const Vec3& point, Eigen::Vector2d& pixel) const {
    const Vec3 seen = point - eye_;
    const double depth = seen.dot(forward_);
    if (depth > 0.0) pixel = middle_ + Eigen::Vector2d(seen.dot(right_), seen.dot(down_)) / depth;
    return depth;
  }

  /// [pixels] that a metre takes at a depth of a metre.
  double pixels() const { return pixels_; }

 private:
  Vec3 eye_, forward_;
  double pixels_;
  Vec3 right_, down_;
  Eigen::Vector2d middle_;
};

}  // namespace

std::optional<Index> pick(std::span<const float> positions, const std::vector<bool>& fixed,
                          const picture::Camera& camera, const Viewport& viewport,
                          const Eigen::Vector2d& pixel, double radius) {
  const Projector projector(camera, viewport);
  std::vector<Candidate> candidates;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; 3 * i < positions.size(); ++i) {
    if (fixed[i]) continue;
    Eigen::Vector2d at;
    const double depth =
        projector.project({positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]}, at);
    if (!(depth > 0.0)) continue;
    const double distance = (at - pixel).norm();
    if (!(distance <= radius)) continue;
    candidates.push_back({Index(i), distance, depth});
    nearest = std::min(nearest, depth);
  }
  // A surface that is seen at a slant may go this many radii deeper within one radius.
  constexpr double slant = 4.0;
  const double deepest = nearest * (1.0 + slant * radius / projector.pixels());
  std::optional<Candidate> best;
  for (const Candidate& candidate : candidates) {
    if (candidate.depth <= deepest && (!best || candidate.distance < best->distance)) best = candidate;
  }
  if (!best) return std::nullopt;
  return best->particle;
}

Vec3 point_under(const picture::Camera& camera, const Viewport& viewport, const Eigen::Vector2d& pixel,
                 double depth) {
  const Eigen::Vector2d place = viewport.place(pixel);
  const Vec3 ray = camera.ray(place.x(), place.y(), viewport.aspect());
  return camera.eye() + ray * (depth / ray.dot(camera.forward()));
}

double depth_of(const picture::Camera& camera, const Vec3& point) {
  return (point - camera.eye()).dot(camera.forward());
}

}  // namespace hooke::viewer
