#pragma once

#include <string>

/// What several shaders begin with, in GLSL.

namespace hooke::picture::glsl {

/// The block of FrameUniforms, and what follows from it.
inline constexpr const char* frame = R"(#version 330 core
layout(std140) uniform Frame {
  mat4 clip_from_world;
  mat4 shadow_from_world;
  vec4 eye;
  vec4 light;
  vec4 up;
  vec4 picture;
};

vec3 to_eye(vec3 place) { return eye.w > 0.0 ? eye.xyz - place : eye.xyz; }

// How many metres a pixel is wide at a place.
float pixel_at(vec3 place) { return up.w * (eye.w > 0.0 ? length(eye.xyz - place) : 1.0); }
)";

/// For shaders that fetch positions themselves: corners of the two triangles of a quad, and a place that is
/// not seen.
inline constexpr const char* pulled = R"(
uniform samplerBuffer positions;
const vec2 corners[6] = vec2[](vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, -1), vec2(1, 1), vec2(-1, 1));
const vec4 nowhere = vec4(2, 2, 2, 1);

vec3 position_of(int particle) {
  return vec3(texelFetch(positions, 3 * particle).r, texelFetch(positions, 3 * particle + 1).r,
              texelFetch(positions, 3 * particle + 2).r);
}

bool is_finite(vec3 v) { return !(any(isnan(v)) || any(isinf(v))); }
)";

/// Light, shadow, and colours as the framebuffer takes them.
inline constexpr const char* lighting = R"(
uniform sampler2DShadow shadow_map;

// The share of the light's disc that is seen from a place [0, 1]: an average over taps x taps places of the map, which
// weigh less the further away they are. They reach so many metres to each side, whatever the size of a texel is: edges
// must not change as the map grows with the scene. `taps` is even.
float seen_light(vec3 place, vec3 normal, int taps, float softness) {
  if (light.w <= 0.0) return 1.0;
  float reach = clamp(softness / light.w, 0.5 * float(taps), 1.25 * float(taps));  // [texels]
  float apart = 2.0 * reach / float(taps);
  vec3 at = (shadow_from_world * vec4(place + 0.7 * reach * light.w * normal, 1.0)).xyz;
  vec2 texel = 1.0 / vec2(textureSize(shadow_map, 0));
  vec2 edge = (reach + 1.0) * texel;
  if (any(lessThan(at.xy, edge)) || any(greaterThan(at.xy, 1.0 - edge))) return 1.0;
  float seen = 0.0;
  for (int y = 0; y < taps; ++y) {
    for (int x = 0; x < taps; ++x) {
      vec2 offset = apart * (vec2(x, y) - 0.5 * float(taps - 1));
      vec2 share = 1.0 - abs(offset) / (reach + 0.5);
      seen += share.x * share.y * texture(shadow_map, vec3(at.xy + offset * texel, at.z));
    }
  }
  float total = float(taps) * (1.0 - 0.25 * apart * float(taps) / (reach + 0.5));  // of the shares in a row
  return seen / (total * total);
}

// Light from all of the sky, and from the ground.
vec3 ambient(vec3 normal) {
  return mix(vec3(0.34, 0.33, 0.33), vec3(0.62, 0.66, 0.72), 0.5 + 0.5 * dot(normal, up.xyz));
}

const vec3 key = vec3(0.92, 0.88, 0.82);

vec3 background() {
  float height = gl_FragCoord.y / picture.y;
  return mix(vec3(0.70, 0.735, 0.77), vec3(0.90, 0.92, 0.94), smoothstep(0.0, 1.0, height));
}

vec4 shown(vec3 linear, float coverage) {
  vec3 c = clamp(linear, 0.0, 1.0);
  if (picture.z > 0.0) {
    c = mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
  }
  return vec4(c, coverage);
}
)";

inline constexpr const char* depth_alone = R"(
void main() {}
)";

inline std::string joined(const char* first, const char* second, const char* third = "",
                          const char* fourth = "") {
  return std::string(first) + second + third + fourth;
}

}  // namespace hooke::picture::glsl
