#pragma once

#include <optional>
#include <span>
#include <vector>

#include <hooke/scene.h>

#include "picture/camera.h"
#include "viewer/viewport.h"

namespace hooke::viewer {

/// The particle that is meant by a place on the screen [pixels]: of those within `radius` [pixels] the
/// nearest one on the screen, but none that lies far behind another of them. `fixed` says which particles
/// cannot be meant; positions are x, y, z of each [m].
std::optional<Index> pick(std::span<const float> positions, const std::vector<bool>& fixed,
                          const picture::Camera& camera, const Viewport& viewport,
                          const Eigen::Vector2d& pixel, double radius);

/// The point [m] under a place on the screen [pixels], at `depth` [m] in front of the eye.
Vec3 point_under(const picture::Camera& camera, const Viewport& viewport, const Eigen::Vector2d& pixel,
                 double depth);

/// Depth [m] of a point [m] in front of the eye.
double depth_of(const picture::Camera& camera, const Vec3& point);

}  // namespace hooke::viewer
