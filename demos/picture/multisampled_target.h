#pragma once

#include "picture/gl_objects.h"
#include "picture/image.h"

namespace hooke::picture {

/// Something to draw into that is not a window, with several samples in each pixel.
class MultisampledTarget {
 public:
  /// Throws PictureError for a size that this driver cannot do.
  MultisampledTarget(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }

  /// Makes drawing go into it.
  void begin() const;

  /// What was drawn.
  Image image() const;

  /// Copies what was drawn into the window, its lower left corner to this pixel of it.
  void show(int left, int bottom) const;

 private:
  void resolve() const;

  int width_, height_;
  Renderbuffer samples_, depths_, pixels_;
  Framebuffer drawn_, resolved_;
};

}  // namespace hooke::picture
