#include "picture/shaders.h"

namespace hooke::picture {
namespace {

constexpr const char* frame = R"(#version 330 core
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

// Corners of the two triangles of a quad; and what the card leaves out.
constexpr const char* pulled = R"(
uniform samplerBuffer positions;
const vec2 corners[6] = vec2[](vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, -1), vec2(1, 1), vec2(-1, 1));
const vec4 nowhere = vec4(2, 2, 2, 1);

vec3 position_of(int particle) {
  return vec3(texelFetch(positions, 3 * particle).r, texelFetch(positions, 3 * particle + 1).r,
              texelFetch(positions, 3 * particle + 2).r);
}

bool is_finite(vec3 v) { return !(any(isnan(v)) || any(isinf(v))); }
)";

constexpr const char* lighting = R"(
uniform sampler2DShadow shadow_map;

// The share of the light's disc that is seen from a place [0, 1]: an average over taps x taps places of the map, so
// many texels apart, which weigh less the further away they are. `taps` is even.
float seen_light(vec3 place, vec3 normal, int taps, float apart) {
  if (light.w <= 0.0) return 1.0;
  float reach = 0.5 * float(taps) * apart;  // [texels]
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
  float all = float(taps) * (1.0 - 0.25 * apart * float(taps) / (reach + 0.5));  // of the shares in a row
  return seen / (all * all);
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

constexpr const char* depth_alone = R"(
void main() {}
)";

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
  vec2 distance = abs(fract(cell - 0.5) - 0.5);
  vec2 cover = clamp(1.25 - distance / width, 0.0, 1.0) * clamp(0.5 / width - 1.0, 0.0, 1.0);
  return max(cover.x, cover.y);
}

void main() {
  float far = length(on_plane) / centre.w;
  float near = 1.0 - smoothstep(0.25, 1.0, far);
  vec3 normal = cross(across, along);
  vec3 tone = vec3(0.83, 0.845, 0.855);
  float line = lines(on_plane + grid.xy, grid.z);
  tone *= 1.0 - 0.13 * line;
  tone *= mix(vec3(0.50, 0.52, 0.56), vec3(1.0), seen_light(place, normal, 8, 1.75));
  colour = shown(mix(background(), tone, near), 1.0);
}
)";

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

constexpr const char* surface_fragment = R"(
in vec3 place;
in vec3 smooth_normal;
out vec4 colour;
const vec3 front = vec3(0.050, 0.235, 0.290);
const vec3 back = vec3(0.540, 0.410, 0.280);

void main() {
  vec3 view = normalize(to_eye(place));
  vec3 normal = normalize(smooth_normal) * (gl_FrontFacing ? 1.0 : -1.0);
  vec3 cloth = gl_FrontFacing ? front : back;
  float slope = dot(normal, light.xyz);
  // Shadows fall on the side that the light sees, whichever side we see.
  float seen = seen_light(place, slope < 0.0 ? -normal : normal, 4, 1.6);
  float direct = max(slope, 0.0) * seen;
  float through = max(-slope, 0.0) * seen;
  float facing = clamp(dot(normal, view), 0.0, 1.0);
  // A weak second light, from beside the eye, shows the shape of what the first one does not reach.
  float fill = max(dot(normal, normalize(view + 0.7 * cross(up.xyz, view) + 0.3 * up.xyz)), 0.0);
  vec3 light_sum = 0.90 * ambient(normal) + 1.20 * key * direct + 0.45 * key * through + 0.75 * fill * fill;
  float highlight = pow(max(dot(normal, normalize(view + light.xyz)), 0.0), 28.0) * direct;
  float rim = pow(1.0 - facing, 4.0);
  vec3 sheen = vec3(0.10) * highlight + 0.10 * rim * ambient(normal);
  colour = shown(cloth * light_sum + sheen, 1.0);
}
)";

constexpr const char* surface_shadow_vertex = R"(
layout(location = 0) in vec3 position;
void main() { gl_Position = clip_from_world * vec4(position, 1.0); }
)";

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

std::string joined(const char* first, const char* second, const char* third = "") {
  return std::string(first) + second + third;
}

}  // namespace

ShaderText background_shaders() {
  return {joined(frame, background_vertex), joined(frame, lighting, background_fragment)};
}

ShaderText ground_shaders() {
  return {joined(frame, ground_vertex), joined(frame, lighting, ground_fragment)};
}

ShaderText surface_shaders() {
  return {joined(frame, surface_vertex), joined(frame, lighting, surface_fragment)};
}

ShaderText spring_shaders() {
  return {joined(frame, pulled, spring_vertex), joined(frame, lighting, spring_fragment)};
}

ShaderText ball_shaders() {
  return {joined(frame, pulled, ball_vertex), joined(frame, lighting, ball_fragment)};
}

ShaderText surface_shadow_shaders() {
  return {joined(frame, surface_shadow_vertex), joined(frame, depth_alone)};
}

ShaderText spring_shadow_shaders() {
  return {joined(frame, pulled, spring_vertex), joined(frame, depth_alone)};
}

ShaderText ball_shadow_shaders() {
  return {joined(frame, pulled, ball_vertex), joined(frame, ball_shadow_fragment)};
}

}  // namespace hooke::picture
