#include "picture/multisampled_target.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "picture/picture_error.h"

namespace hooke::picture {
namespace {

constexpr int wanted_samples = 4;

GLint limit(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

void attach(const Renderbuffer& buffer, GLenum attachment, GLenum format, int samples, int width,
            int height) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.name());
}

void require_complete(int width, int height) {
  if (glGetError() == GL_NO_ERROR && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE)
    return;
  throw PictureError("the OpenGL driver has no room for a picture of " + std::to_string(width) + " x " +
                     std::to_string(height) + " pixels: give a smaller one");
}

int checked(const char* what, int pixels) {
  const GLint most = std::min(limit(GL_MAX_RENDERBUFFER_SIZE), limit(GL_MAX_VIEWPORT_DIMS));
  if (pixels >= 1 && pixels <= most) return pixels;
  throw PictureError(std::string(what) + " of a picture is " + std::to_string(pixels) +
                     " pixels: give 1 to " + std::to_string(most));
}

}  // namespace

MultisampledTarget::MultisampledTarget(int width, int height)
    : width_(checked("width", width)), height_(checked("height", height)) {
  const int samples = std::min(wanted_samples, int(limit(GL_MAX_SAMPLES)));
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_.name());
  attach(samples_, GL_COLOR_ATTACHMENT0, GL_SRGB8_ALPHA8, samples, width, height);
  attach(depths_, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, samples, width, height);
  require_complete(width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_.name());
  attach(pixels_, GL_COLOR_ATTACHMENT0, GL_SRGB8_ALPHA8, 0, width, height);
  require_complete(width, height);
}

void MultisampledTarget::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_.name());
}

void MultisampledTarget::resolve() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.name());
  glEnable(GL_FRAMEBUFFER_SRGB);  // samples are averaged as light, not as the bytes that stand for it
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glDisable(GL_FRAMEBUFFER_SRGB);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.name());
}

void MultisampledTarget::show(int left, int bottom) const {
  resolve();
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, width_, height_, left, bottom, left + width_, bottom + height_, GL_COLOR_BUFFER_BIT,
                    GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
}

Image MultisampledTarget::image() const {
  resolve();
  std::vector<std::uint8_t> rgba(4 * std::size_t(width_) * std::size_t(height_));
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  Image image(width_, height_);
  for (int row = 0; row < height_; ++row) {  // OpenGL counts rows from below
    const std::uint8_t* from = rgba.data() + 4 * std::size_t(height_ - 1 - row) * std::size_t(width_);
    std::uint8_t* to = image.pixel(0, row);
    for (int column = 0; column < width_; ++column, from += 4, to += 3) std::copy_n(from, 3, to);
  }
  return image;
}

}  // namespace hooke::picture
