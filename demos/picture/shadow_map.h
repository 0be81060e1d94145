#pragma once

#include "picture/gl_objects.h"

namespace hooke::picture {

/// How far the light sees, as a texture of depths.
class ShadowMap {
 public:
  static constexpr int texels = 512;

  ShadowMap();

  /// Makes drawing go into the map, which is cleared.
  void begin() const;
  void bind(GLuint unit) const;

 private:
  Texture depths_;
  Framebuffer framebuffer_;
};

}  // namespace hooke::picture
