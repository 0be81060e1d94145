#include "picture/shader_parts.h"
#include "picture/shaders.h"

namespace hooke::picture {

using namespace glsl;

namespace {

constexpr const char* background_vertex = R"(
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 1.0, 1.0); }
)";

constexpr const char* background_fragment = R"(
out vec4 colour;
void main() { colour = shown(background(), 1.0); }
)";

constexpr const char* ground_vertex = R"(
uniform vec4 centre;   // [m]; its radius
uniform vec3 along;    // unit vectors in the plane
uniform vec3 across;
out vec3 place;
out vec2 on_plane;     // [m] from the centre
const vec2 corners[4] = vec2[](vec2(-1, -1), vec2(1, -1), vec2(-1, 1), vec2(1, 1));
void main() {
  on_plane = centre.w * corners[gl_VertexID];
  place = centre.xyz + on_plane.x * along + on_plane.y * across;
  gl_Position = clip_from_world * vec4(place, 1.0);
}
)";

constexpr const char* ground_fragment = R"(
uniform vec4 centre;
uniform vec3 along;
uniform vec3 across;
uniform vec3 grid;     // where the centre lies in it [m]; spacing of its lines [m]
in vec3 place;
in vec2 on_plane;
out vec4 colour;

// How much of this pixel is covered by lines a pixel and a half wide.
float lines(vec2 at, float spacing) {
  vec2 cell = at / spacing;
  vec2 width = fwidth(cell);
  vec2 off = abs(fract(cell - 0.5) - 0.5);
  vec2 cover = clamp(1.25 - off / width, 0.0, 1.0) * clamp(0.5 / width - 1.0, 0.0, 1.0);
  return max(cover.x, cover.y);
}

void main() {
  float far = length(on_plane) / centre.w;
  float near = 1.0 - smoothstep(0.25, 1.0, far);
  vec3 normal = cross(across, along);
  vec3 tone = vec3(0.83, 0.845, 0.855);
  float line = lines(on_plane + grid.xy, grid.z);
  tone *= 1.0 - 0.13 * line;
  tone *= mix(vec3(0.50, 0.52, 0.56), vec3(1.0), seen_light(place, normal, 8, picture.w));
  colour = shown(mix(background(), tone, near), 1.0);
}
)";

}  // namespace

ShaderText background_shaders() {
  return {joined(frame, background_vertex), joined(frame, lighting, background_fragment)};
}

ShaderText ground_shaders() {
  return {joined(frame, ground_vertex), joined(frame, lighting, ground_fragment)};
}

}  // namespace hooke::picture
