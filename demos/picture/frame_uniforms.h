#pragma once

#include <array>

#include <Eigen/Core>

namespace hooke::picture {

/// What all shaders know of a picture, as the block `Frame` lays it out (std140).
struct FrameUniforms {
  Eigen::Matrix4f clip_from_world;
  Eigen::Matrix4f shadow_from_world;  ///< to [0, 1]^3: a place and a depth in the shadow map
  std::array<float, 4> eye{};         ///< [m] and 1; or the direction to it and 0, where it is infinitely far
  std::array<float, 4> light{};  ///< unit vector to the light; size of a texel of the shadow map [m], or 0
  std::array<float, 4> up{};     ///< unit vector; metres in a pixel at a distance of 1 m (at any, if far)
  std::array<float, 4>
      picture{};  ///< width and height [pixels]; 1 where shaders encode sRGB; softness of shadows [m]
};
static_assert(sizeof(FrameUniforms) == 2 * 64 + 4 * 16);

/// Where the block is bound, and the texture units.
enum BindingPoint : unsigned { frame_block = 0 };
enum TextureUnit : int { position_unit = 0, item_unit = 1, rest_length_unit = 2, shadow_unit = 3 };

}  // namespace hooke::picture
