#include "picture/shader_parts.h"
#include "picture/shaders.h"

namespace hooke::picture {

using namespace glsl;

namespace {

constexpr const char* ball_vertex = R"(
uniform usamplerBuffer items;
uniform bool all_particles;
uniform vec3 radius;  // [m]; the least and the most [pixels]
out vec2 on_disc;
flat out vec3 centre;
flat out vec3 towards;
flat out vec3 rightwards;
flat out float size;

void main() {
  int ball = gl_VertexID / 6;
  on_disc = 1.15 * corners[gl_VertexID % 6];
  centre = position_of(all_particles ? ball : int(texelFetch(items, ball).r));
  gl_Position = nowhere;
  towards = rightwards = vec3(0);
  size = 0.0;
  if (!is_finite(centre)) return;
  towards = normalize(to_eye(centre));
  vec3 aside = abs(dot(towards, up.xyz)) < 0.99 ? up.xyz : vec3(up.y, up.z, up.x);
  rightwards = normalize(cross(aside, towards));
  size = clamp(radius.x, radius.y * pixel_at(centre), radius.z * pixel_at(centre));
  vec3 place = centre + size * (on_disc.x * rightwards + on_disc.y * cross(towards, rightwards) + towards);
  gl_Position = clip_from_world * vec4(place, 1.0);
}
)";

constexpr const char* ball_fragment = R"(
uniform vec3 tone;
in vec2 on_disc;
flat in vec3 centre;
flat in vec3 towards;
flat in vec3 rightwards;
flat in float size;
out vec4 colour;

void main() {
  float from_centre = length(on_disc);
  // The edge as a coverage, which multisampling turns into samples.
  float coverage = clamp((1.0 - from_centre) / fwidth(from_centre) + 0.5, 0.0, 1.0);
  if (coverage <= 0.0) discard;
  vec3 normal = normalize(on_disc.x * rightwards + on_disc.y * cross(towards, rightwards) +
                          sqrt(max(0.0, 1.0 - from_centre * from_centre)) * towards);
  vec3 view = normalize(to_eye(centre));
  float direct = max(dot(normal, light.xyz), 0.0);
  float highlight = pow(max(dot(normal, normalize(view + light.xyz)), 0.0), 40.0);
  colour = shown(tone * (0.9 * ambient(normal) + 1.1 * key * direct) + 0.25 * highlight, coverage);
}
)";

constexpr const char* ball_shadow_fragment = R"(
in vec2 on_disc;
void main() {
  if (dot(on_disc, on_disc) > 1.0) discard;
}
)";

}  // namespace

ShaderText ball_shaders() {
  return {joined(frame, pulled, ball_vertex), joined(frame, lighting, ball_fragment)};
}

ShaderText ball_shadow_shaders() {
  return {joined(frame, pulled, ball_vertex), joined(frame, ball_shadow_fragment)};
}

}  // namespace hooke::picture
