#include "picture/painter.h"

#include <optional>
#include <utility>

#include "picture/multisampled_target.h"
#include "picture/offscreen_context.h"
#include "picture/picture_error.h"
#include "picture/renderer.h"

namespace hooke::picture {

struct Painter::Parts {
  OffscreenContext context;
  // These live in the context: they are made and deleted while it is current.
  std::optional<Renderer> renderer;
  std::optional<MultisampledTarget> target;

  ~Parts() {
    const OffscreenContext::Current current(context);
    renderer.reset();
    target.reset();
  }
};

Painter::Painter(Subject subject, int width, int height) : parts_(std::make_unique<Parts>()) {
  const OffscreenContext::Current current(parts_->context);
  parts_->target.emplace(width, height);
  parts_->renderer.emplace(std::move(subject));
}

Painter::~Painter() = default;
Painter::Painter(Painter&&) noexcept = default;
Painter& Painter::operator=(Painter&&) noexcept = default;

void Painter::change(Subject subject) {
  const OffscreenContext::Current current(parts_->context);
  parts_->renderer.emplace(std::move(subject));
}

Image Painter::paint(std::span<const float> positions, const Camera& camera, const Look& look) {
  const OffscreenContext::Current current(parts_->context);
  parts_->renderer->upload(positions);
  parts_->target->begin();
  parts_->renderer->draw(camera, look, parts_->target->width(), parts_->target->height());
  Image image = parts_->target->image();
  if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
    throw PictureError("OpenGL error " + std::to_string(error) + " while a picture was drawn");
  }
  return image;
}

std::string Painter::driver() const {
  const OffscreenContext::Current current(parts_->context);
  return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

}  // namespace hooke::picture
