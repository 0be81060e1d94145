#pragma once

#include <memory>

namespace hooke::picture {

/// An OpenGL 3.3 context that needs no screen, from EGL: of a graphics card where there is one, else of
/// Mesa's software driver.
class OffscreenContext {
 public:
  /// Throws PictureError where there is none, saying what to install.
  OffscreenContext();
  ~OffscreenContext();
  OffscreenContext(OffscreenContext&&) noexcept;
  OffscreenContext& operator=(OffscreenContext&&) noexcept;

  /// While it lives, the context is this thread's; then whatever was before is again.
  class Current {
   public:
    explicit Current(const OffscreenContext& context);
    ~Current();
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

   private:
    struct Before;
    std::unique_ptr<Before> before_;
  };

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hooke::picture
