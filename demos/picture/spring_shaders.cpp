#include "picture/shader_parts.h"
#include "picture/shaders.h"

namespace hooke::picture {

using namespace glsl;

namespace {

constexpr const char* spring_vertex = R"(
uniform usamplerBuffer items;
uniform samplerBuffer rest_lengths;
uniform float full_strain;
uniform vec3 radius;  // [m]; the least and the most [pixels]
out vec3 place;
out vec3 outwards;    // unit vectors: across the line, and towards the eye
out vec3 towards;
out float across;     // from -1 to 1
flat out float strain;

void main() {
  int spring = gl_VertexID / 6;
  vec2 corner = corners[gl_VertexID % 6];
  uvec2 end = texelFetch(items, spring).rg;
  vec3 first = position_of(int(end.x)), second = position_of(int(end.y));
  float rest_length = texelFetch(rest_lengths, spring).r;
  vec3 axis = second - first;
  float length_now = length(axis);
  gl_Position = nowhere;
  strain = 0.0;
  across = corner.y;
  place = outwards = towards = vec3(0);
  if (!is_finite(axis) || !(length_now > 0.0)) return;
  if (rest_length > 0.0) strain = clamp((length_now - rest_length) / (rest_length * full_strain), -1.0, 1.0);
  place = corner.x < 0.0 ? first : second;
  towards = normalize(to_eye(place));
  outwards = cross(axis / length_now, towards);
  float seen_width = length(outwards);
  outwards = seen_width > 1e-6 ? outwards / seen_width : vec3(0);
  float half_width = clamp(radius.x, radius.y * pixel_at(place), radius.z * pixel_at(place));
  // A little too long, so that there are no gaps where springs meet; and in front of a surface that they lie in.
  place += half_width * (corner.y * outwards + 0.5 * corner.x * axis / length_now + towards);
  gl_Position = clip_from_world * vec4(place, 1.0);
}
)";

constexpr const char* spring_fragment = R"(
in vec3 place;
in vec3 outwards;
in vec3 towards;
in float across;
flat in float strain;
out vec4 colour;
const vec3 pressed = vec3(0.010, 0.130, 0.560);
const vec3 rest = vec3(0.330, 0.340, 0.350);
const vec3 stretched = vec3(0.700, 0.050, 0.015);

void main() {
  vec3 normal = normalize(across * outwards + sqrt(max(0.0, 1.0 - across * across)) * towards);
  vec3 tone = mix(rest, strain < 0.0 ? pressed : stretched, abs(strain));
  float direct = max(dot(normal, light.xyz), 0.0);
  colour = shown(tone * (0.55 + 0.55 * ambient(normal) + 0.5 * key * direct), 1.0);
}
)";

}  // namespace

ShaderText spring_shaders() {
  return {joined(frame, pulled, spring_vertex), joined(frame, lighting, spring_fragment)};
}

ShaderText spring_shadow_shaders() {
  return {joined(frame, pulled, spring_vertex), joined(frame, depth_alone)};
}

}  // namespace hooke::picture
