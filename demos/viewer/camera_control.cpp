#include "viewer/camera_control.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "viewer/picking.h"

namespace hooke::viewer {
namespace {

/// The box around all finite points.
Eigen::AlignedBox3f box_around(std::span<const float> points) {
  Eigen::AlignedBox3f box;
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    const Eigen::Vector3f point(points[i], points[i + 1], points[i + 2]);
    if (point.allFinite()) box.extend(point);
  }
  return box;
}

std::array<float, 24> corners_of(const Eigen::AlignedBox3f& box) {
  std::array<float, 24> corners;
  for (unsigned i = 0; i < 8; ++i) {
    for (unsigned axis = 0; axis < 3; ++axis)
      corners[3 * i + axis] = (i >> axis & 1) != 0 ? box.max()[axis] : box.min()[axis];
  }
  return corners;
}

/// [m] at the target's depth for each pixel.
double metres_per_pixel(const picture::Camera& camera, const Viewport& viewport) {
  return 2.0 * camera.distance * std::tan(0.5 * camera.field_of_view) / viewport.height;
}

}  // namespace

CameraControl::CameraControl(const Vec3& up) {
  goal_.up = up;
  shown_ = goal_;
}

void CameraControl::orbit(const Eigen::Vector2d& moved, const Viewport& viewport) {
  constexpr double steepest = 0.495 * std::numbers::pi;
  const double radians = std::numbers::pi / viewport.height;  // the height of the view is half a turn
  goal_.azimuth -= radians * moved.x();
  goal_.elevation = std::clamp(goal_.elevation + radians * moved.y(), -steepest, steepest);
  follows_ = false;
}

void CameraControl::pan(const Eigen::Vector2d& moved, const Viewport& viewport) {
  goal_.target += metres_per_pixel(goal_, viewport) * (moved.y() * goal_.over() - moved.x() * goal_.right());
  follows_ = false;
}

void CameraControl::zoom(double notches, const Eigen::Vector2d& pixel, const Viewport& viewport) {
  const double factor = std::pow(0.88, notches);
  const Vec3 under = point_under(goal_, viewport, pixel, goal_.distance);
  goal_.target = under + factor * (goal_.target - under);
  goal_.distance *= factor;
  follows_ = false;
}

void CameraControl::fit(std::span<const float> points, const Viewport& viewport) {
  follows_ = true;
  seen_ = box_around(points);
  fit_box(viewport);
}

void CameraControl::follow(std::span<const float> points, const Viewport& viewport) {
  if (!follows_) return;
  const Eigen::AlignedBox3f box = box_around(points);
  if (box.isEmpty() || seen_.contains(box)) return;
  seen_.extend(box);
  fit_box(viewport);
}

void CameraControl::fit_box(const Viewport& viewport) {
  constexpr double margin = 0.1;
  if (!seen_.isEmpty()) goal_ = picture::fitted(goal_, corners_of(seen_), viewport.aspect(), margin);
}

void CameraControl::advance(double seconds) {
  constexpr double time_constant = 0.045;  // [s]
  const double share = 1.0 - std::exp(-seconds / time_constant);
  shown_.target += share * (goal_.target - shown_.target);
  shown_.azimuth += share * (goal_.azimuth - shown_.azimuth);
  shown_.elevation += share * (goal_.elevation - shown_.elevation);
  shown_.distance *= std::pow(goal_.distance / shown_.distance, share);
}

bool CameraControl::moves() const {
  constexpr double visible = 1e-4;
  return std::abs(goal_.azimuth - shown_.azimuth) > visible ||
         std::abs(goal_.elevation - shown_.elevation) > visible ||
         std::abs(goal_.distance / shown_.distance - 1.0) > visible ||
         (goal_.target - shown_.target).norm() > visible * goal_.distance;
}

}  // namespace hooke::viewer
