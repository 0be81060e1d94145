#include "picture/renderer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "picture/background_layer.h"
#include "picture/ball_layer.h"
#include "picture/bounds.h"
#include "picture/frame_uniforms.h"
#include "picture/framing.h"
#include "picture/gl_objects.h"
#include "picture/ground_layer.h"
#include "picture/light_box.h"
#include "picture/light_direction.h"
#include "picture/picture_error.h"
#include "picture/shadow_map.h"
#include "picture/sizes.h"
#include "picture/solid_layer.h"
#include "picture/spring_layer.h"
#include "picture/subject_check.h"
#include "picture/surface_layer.h"

namespace hooke::picture {
namespace {

/// The subject, where this context can draw it.
Subject drawable(Subject subject) {
  require_consistent(subject);
  if (const int version = epoxy_gl_version(); version < 33) {
    throw PictureError("pictures need OpenGL 3.3, and this driver has " + std::to_string(version / 10) + "." +
                       std::to_string(version % 10) + ": update it, or install Mesa's (libgl1-mesa-dri)");
  }
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  if (3 * subject.particles > std::size_t(most) || subject.springs.size() > std::size_t(most)) {
    throw PictureError(std::to_string(subject.particles) + " particles and " +
                       std::to_string(subject.springs.size()) +
                       " springs are more than this OpenGL driver can draw: it takes " +
                       std::to_string(most / 3) + " and " + std::to_string(most));
  }
  return subject;
}

/// Whether colours are encoded as sRGB on their way into the framebuffer that is bound, once asked to.
bool encodes_srgb() {
  GLint bound = 0, encoding = GL_LINEAR;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, bound == 0 ? GL_BACK_LEFT : GL_COLOR_ATTACHMENT0,
                                        GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING, &encoding);
  return encoding == GL_SRGB;
}

/// How wide a pixel is at a distance of 1 m [m].
double pixel_slope(const Camera& camera, int height) {
  return 2.0 * std::tan(0.5 * camera.field_of_view) / height;
}

/// What OpenGL starts with, but for the test of depths.
void set_state() {
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
}

/// Leaves nothing bound that others might change by mistake.
void reset_state() {
  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(0);
  glUseProgram(0);
  for (const int unit : {position_unit, item_unit, rest_length_unit}) {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_BUFFER, 0);
  }
  glActiveTexture(GL_TEXTURE0 + shadow_unit);
  glBindTexture(GL_TEXTURE_2D, 0);
  glActiveTexture(GL_TEXTURE0);
}

std::array<float, 4> four(const Vec3& vector, double last) {
  return {float(vector.x()), float(vector.y()), float(vector.z()), float(last)};
}

}  // namespace

struct Renderer::Parts {
  explicit Parts(Subject subject_)
      : subject(drawable(std::move(subject_))),
        sizes(sizes_of(subject)),
        to_light(direction_to_light(subject.up)),
        position_texture(positions, GL_R32F),
        surface(subject.triangles, positions),
        springs(subject),
        balls(subject.pins),
        solids(subject.solids) {}

  FrameUniforms seen_by_light(const LightBox& box) const;
  FrameUniforms seen_by_eye(const Camera& camera, const LightBox& box, const Look& look, int width,
                            int height) const;
  void set_uniforms(const FrameUniforms& uniforms) const;
  void draw_things(Seen seen, const Look& look, const Sizes& drawn) const;
  void cast_shadows(const LightBox& box, const Look& look, const Sizes& drawn) const;
  void draw_grounds(const Camera& camera, const Look& look) const;

  Subject subject;
  Sizes sizes;
  Vec3 to_light;
  Bounds bounds;
  Buffer positions, frame;
  BufferTexture position_texture;
  BackgroundLayer background;
  GroundLayer ground;
  SurfaceLayer surface;
  SpringLayer springs;
  BallLayer balls;
  SolidLayer solids;
  ShadowMap shadow_map;
};

FrameUniforms Renderer::Parts::seen_by_light(const LightBox& box) const {
  return {.clip_from_world = box.clip_from_world,
          .shadow_from_world = box.shadow_from_world,
          .eye = four(to_light, 0.0),
          .light = four(to_light, 0.0),
          .up = four(subject.up, box.texel)};
}

FrameUniforms Renderer::Parts::seen_by_eye(const Camera& camera, const LightBox& box, const Look& look,
                                           int width, int height) const {
  double far = camera.distance + GroundLayer::radius(camera);
  for (const Vec3& corner : bounds.corners()) {
    far = std::max(far, (corner - camera.eye()).dot(camera.forward()));
  }
  const double aspect = double(width) / height;
  return {.clip_from_world = camera.projection(aspect, 0.02 * camera.distance, 1.01 * far) * camera.view(),
          .shadow_from_world = box.shadow_from_world,
          .eye = four(camera.eye(), 1.0),
          .light = four(to_light, look.shadow ? box.texel : 0.0),
          .up = four(subject.up, pixel_slope(camera, height)),
          .picture = {float(width), float(height), encodes_srgb() ? 0.0f : 1.0f,
                      float(0.018 * height_seen(camera))}};
}

void Renderer::Parts::set_uniforms(const FrameUniforms& uniforms) const {
  glBindBuffer(GL_UNIFORM_BUFFER, frame.name());
  glBufferData(GL_UNIFORM_BUFFER, sizeof(uniforms), &uniforms, GL_STREAM_DRAW);
  glBindBufferBase(GL_UNIFORM_BUFFER, frame_block, frame.name());
}

void Renderer::Parts::draw_things(Seen seen, const Look& look, const Sizes& drawn) const {
  if (look.solids) solids.draw(seen);
  if (look.surface) surface.draw(seen);
  if (look.springs) springs.draw(seen, drawn.spring, look.full_strain);
  if (look.particles) balls.draw_particles(seen, drawn.particle, subject.particles);
  if (look.pins) balls.draw_pins(seen, drawn.pin);
}

void Renderer::Parts::cast_shadows(const LightBox& box, const Look& look, const Sizes& drawn) const {
  GLint framebuffer = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  set_uniforms(seen_by_light(box));
  shadow_map.begin();
  // So that a surface does not shade itself: what is cast lies a little behind what casts it.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(2.0f, 4.0f);
  draw_things(Seen::by_light, look, drawn);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(framebuffer));
}

void Renderer::Parts::draw_grounds(const Camera& camera, const Look& look) const {
  for (const GroundPlane& plane : subject.grounds)
    ground.draw(plane.normal.normalized(), plane.height, camera);
  if (!subject.grounds.empty()) return;
  ground.draw(subject.up, look.floor_height.value_or(floor_under(bounds, subject.up)), camera);
}

Renderer::Renderer(Subject subject) : parts_(std::make_unique<Parts>(std::move(subject))) {
  // Until there are positions, nothing is where it can be seen.
  upload(std::vector<float>(3 * parts_->subject.particles, std::numeric_limits<float>::quiet_NaN()));
}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

const Subject& Renderer::subject() const {
  return parts_->subject;
}

void Renderer::upload(std::span<const float> positions) {
  if (positions.size() != 3 * parts_->subject.particles) {
    throw PictureError(std::to_string(positions.size()) + " coordinates for " +
                       std::to_string(parts_->subject.particles) +
                       " particles: give x, y and z of each particle");
  }
  parts_->bounds = bounds_of(positions);
  parts_->surface.upload(positions, parts_->bounds.all_finite);
  parts_->positions.stream(GL_ARRAY_BUFFER, positions);
}

void Renderer::draw(const Camera& camera, const Look& look, int width, int height) {
  const Sizes sizes = at_height(parts_->sizes, height);
  const Sizes shadow_sizes = in_shadow(sizes, camera.distance * pixel_slope(camera, height));
  const double thickest = std::max(shadow_sizes.particle.metres, shadow_sizes.pin.metres);
  const LightBox box = light_box(parts_->bounds, thickest, parts_->to_light, ShadowMap::texels);
  set_state();
  parts_->solids.place(look.time);
  parts_->position_texture.bind(position_unit);
  if (look.shadow) parts_->cast_shadows(box, look, shadow_sizes);
  const FrameUniforms uniforms = parts_->seen_by_eye(camera, box, look, width, height);
  parts_->set_uniforms(uniforms);
  parts_->shadow_map.bind(shadow_unit);
  glViewport(0, 0, width, height);
  if (uniforms.picture[2] == 0.0f) glEnable(GL_FRAMEBUFFER_SRGB);
  glClear(GL_DEPTH_BUFFER_BIT);
  parts_->background.draw();
  if (look.ground) parts_->draw_grounds(camera, look);
  parts_->draw_things(Seen::by_eye, look, sizes);
  glDisable(GL_FRAMEBUFFER_SRGB);
  reset_state();
}

}  // namespace hooke::picture
