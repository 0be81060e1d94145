// The renderer as a window uses it: into a framebuffer that someone else has bound, and that takes no sRGB.

#include <epoxy/gl.h>

#include "drawing.h"
#include "picture/gl_objects.h"
#include "picture/renderer.h"

using namespace hooke;
using namespace hooke::picture;
using namespace hooke::test;

namespace {

/// A framebuffer of plain bytes with one sample, as most windows have.
struct Plain {
  Plain() {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    attach(colour, GL_COLOR_ATTACHMENT0, GL_RGBA8);
    attach(depth, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24);
    REQUIRE(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
  }
  static void attach(const Renderbuffer& buffer, GLenum attachment, GLenum format) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
    glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.name());
  }

  Image read() const {
    std::vector<std::uint8_t> rgba(4u * width * height);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    Image image(width, height);
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        std::copy_n(rgba.data() + 4 * (std::size_t(height - 1 - row) * width + std::size_t(column)), 3,
                    image.pixel(column, row));
      }
    }
    return image;
  }

  Framebuffer framebuffer;
  Renderbuffer colour, depth;
};

GLint value(GLenum name) {
  GLint result = 0;
  glGetIntegerv(name, &result);
  return result;
}

const Surface sphere = ball(32, 16);
const Camera camera{.distance = 5.0};
const Look look{.particles = false};

}  // namespace

TEST_CASE("a renderer draws into the framebuffer that is bound what a painter paints") {
  if (!can_draw()) return;
  const Image painted = Painter(subject_of(sphere), width, height).paint(sphere.positions, camera, look);
  const OffscreenContext context;
  const OffscreenContext::Current current(context);
  const Plain plain;
  Renderer renderer(subject_of(sphere));
  renderer.upload(sphere.positions);
  renderer.draw(camera, look, width, height);
  CHECK(value(GL_DRAW_FRAMEBUFFER_BINDING) == GLint(plain.framebuffer.name()));
  // The same colours, though the shaders themselves encode them here; edges have one sample only.
  CHECK(count(difference(plain.read(), painted, 2)) < 0.02 * width * height);
  CHECK(glGetError() == GL_NO_ERROR);
}

TEST_CASE("a renderer leaves a state that others can draw in, and does not mind theirs") {
  if (!can_draw()) return;
  const OffscreenContext context;
  const OffscreenContext::Current current(context);
  const Plain plain;
  Renderer renderer(subject_of(sphere));
  renderer.upload(sphere.positions);
  renderer.draw(camera, {}, width, height);
  const Image first = plain.read();
  // As Dear ImGui leaves it, and worse.
  glEnable(GL_BLEND);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, 5, 5);
  glEnable(GL_CULL_FACE);
  glDepthMask(GL_FALSE);
  glColorMask(GL_FALSE, GL_TRUE, GL_TRUE, GL_TRUE);
  glActiveTexture(GL_TEXTURE2);
  renderer.draw(camera, {}, width, height);
  CHECK(plain.read().rgb == first.rgb);
  for (const GLenum name : {GL_BLEND, GL_SCISSOR_TEST, GL_CULL_FACE, GL_DEPTH_TEST, GL_FRAMEBUFFER_SRGB,
                            GL_POLYGON_OFFSET_FILL, GL_SAMPLE_ALPHA_TO_COVERAGE}) {
    CHECK_FALSE(glIsEnabled(name));
  }
  CHECK(value(GL_CURRENT_PROGRAM) == 0);
  CHECK(value(GL_VERTEX_ARRAY_BINDING) == 0);
  CHECK(value(GL_ACTIVE_TEXTURE) == GL_TEXTURE0);
  CHECK(value(GL_TEXTURE_BINDING_2D) == 0);
  CHECK(glGetError() == GL_NO_ERROR);
}

TEST_CASE("a renderer that has no positions yet draws the ground") {
  if (!can_draw()) return;
  const OffscreenContext context;
  const OffscreenContext::Current current(context);
  const Plain plain;
  Renderer renderer(subject_of(sphere));
  renderer.draw(camera, {}, width, height);
  CHECK(glGetError() == GL_NO_ERROR);
  CHECK(renderer.subject().particles == sphere.corners());
}

TEST_CASE("a context is put back as it was") {
  if (!can_draw()) return;
  const OffscreenContext outer;
  const OffscreenContext::Current current(outer);
  const Framebuffer mine;
  glBindFramebuffer(GL_FRAMEBUFFER, mine.name());
  Painter(subject_of(sphere), width, height).paint(sphere.positions, camera, {});
  CHECK(value(GL_DRAW_FRAMEBUFFER_BINDING) == GLint(mine.name()));
}
