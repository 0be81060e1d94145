#include "picture/shader_parts.h"
#include "picture/shaders.h"

namespace hooke::picture {

using namespace glsl;

namespace {

constexpr const char* surface_vertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal_sum;
out vec3 place;
out vec3 smooth_normal;
void main() {
  place = position;
  // Sums of areas may be so small that their squares vanish.
  float largest = max(max(abs(normal_sum.x), abs(normal_sum.y)), abs(normal_sum.z));
  smooth_normal = largest > 0.0 ? normalize(normal_sum / largest) : up.xyz;
  gl_Position = clip_from_world * vec4(position, 1.0);
}
)";

constexpr const char* cloth_colours = R"(
const vec3 front = vec3(0.038, 0.215, 0.280);
const vec3 back = vec3(0.480, 0.365, 0.250);
)";

constexpr const char* solid_colours = R"(
const vec3 front = vec3(0.34, 0.34, 0.36);
const vec3 back = front;
)";

constexpr const char* surface_fragment = R"(
in vec3 place;
in vec3 smooth_normal;
out vec4 colour;

void main() {
  vec3 view = normalize(to_eye(place));
  vec3 normal = normalize(smooth_normal) * (gl_FrontFacing ? 1.0 : -1.0);
  vec3 cloth = gl_FrontFacing ? front : back;
  float slope = dot(normal, light.xyz);
  // Shadows fall on the side that the light sees, whichever side we see.
  float seen = seen_light(place, slope < 0.0 ? -normal : normal, 4, 0.5 * picture.w);
  float direct = max(slope, 0.0) * seen;
  float through = max(-slope, 0.0) * seen;
  float facing = clamp(dot(normal, view), 0.0, 1.0);
  // A weak second light, from beside the eye, shows the shape of what the first one does not reach.
  float fill = max(dot(normal, normalize(view + 0.7 * cross(up.xyz, view) + 0.3 * up.xyz)), 0.0);
  vec3 light_sum = 0.80 * ambient(normal) + 1.30 * key * direct + 0.45 * key * through + 0.70 * fill * fill * (1.0 - direct);
  float highlight = pow(max(dot(normal, normalize(view + light.xyz)), 0.0), 28.0) * direct;
  float rim = pow(1.0 - facing, 4.0);
  vec3 sheen = vec3(0.08) * highlight + 0.07 * rim * ambient(normal);
  colour = shown(cloth * light_sum + sheen, 1.0);
}
)";

constexpr const char* surface_shadow_vertex = R"(
layout(location = 0) in vec3 position;
void main() { gl_Position = clip_from_world * vec4(position, 1.0); }
)";

}  // namespace

ShaderText surface_shaders() {
  return {joined(frame, surface_vertex), joined(frame, lighting, cloth_colours, surface_fragment)};
}

ShaderText solid_shaders() {
  return {joined(frame, surface_vertex), joined(frame, lighting, solid_colours, surface_fragment)};
}

ShaderText surface_shadow_shaders() {
  return {joined(frame, surface_shadow_vertex), joined(frame, depth_alone)};
}

}  // namespace hooke::picture
