#pragma once

#include <Eigen/Core>

#include "picture/bounds.h"

namespace hooke::picture {

/// What the sun sees: a cube around a scene, looked at along the light's direction.
struct LightBox {
  Eigen::Matrix4f clip_from_world;
  Eigen::Matrix4f shadow_from_world;  ///< likewise, to [0, 1]^3
  double texel;                       ///< [m] wide
};

/// Around bounds and `margin` [m] more, for a shadow map of `texels` x `texels`. The box grows and moves in
/// steps, so that from frame to frame the edges of shadows do not flicker.
LightBox light_box(const Bounds& bounds, double margin, const Eigen::Vector3d& to_light, int texels);

}  // namespace hooke::picture
