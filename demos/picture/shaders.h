#pragma once

#include <string>

/// The shaders, in GLSL 3.30. All of them read the same block of uniforms (frame_uniforms.h).

namespace hooke::picture {

struct ShaderText {
  std::string vertex, fragment;
};

ShaderText background_shaders();
ShaderText ground_shaders();
ShaderText surface_shaders();
ShaderText solid_shaders();  ///< the same in grey
ShaderText spring_shaders();
ShaderText ball_shaders();

/// Likewise into the shadow map: depth alone.
ShaderText surface_shadow_shaders();
ShaderText spring_shadow_shaders();
ShaderText ball_shadow_shaders();

}  // namespace hooke::picture
