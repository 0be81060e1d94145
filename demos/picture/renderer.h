#pragma once

#include <memory>
#include <span>

#include "picture/camera.h"
#include "picture/subject.h"

namespace hooke::picture {

/// Draws a subject with OpenGL 3.3 (core profile). Needs a current context wherever it is used, and the same
/// one each time.
class Renderer {
 public:
  /// Throws PictureError where the context is too old.
  explicit Renderer(Subject subject);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Takes new positions: x, y, z of each particle [m], in the user's numbering.
  void upload(std::span<const float> positions);

  /// Draws the positions uploaded last into the framebuffer that is bound, over all of its `width` x `height`
  /// pixels. Leaves no OpenGL error behind.
  void draw(const Camera& camera, const Look& look, int width, int height);

  const Subject& subject() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hooke::picture
