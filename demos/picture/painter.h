#pragma once

#include <memory>
#include <span>
#include <string>

#include "picture/camera.h"
#include "picture/image.h"
#include "picture/subject.h"

namespace hooke::picture {

/// Draws pictures of a subject without a screen: on the graphics card through EGL, or with Mesa's software
/// driver where there is none.
class Painter {
 public:
  /// Pictures of `width` x `height` pixels. Throws PictureError where there is no EGL, or none that can draw
  /// with OpenGL 3.3, saying what to install.
  Painter(Subject subject, int width, int height);
  ~Painter();
  Painter(Painter&&) noexcept;
  Painter& operator=(Painter&&) noexcept;

  /// Draws another subject from now on.
  void change(Subject subject);

  /// A picture of the subject with these positions: x, y, z of each particle [m], in the user's numbering.
  Image paint(std::span<const float> positions, const Camera& camera, const Look& look);

  /// What draws, in the driver's words.
  std::string driver() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hooke::picture
