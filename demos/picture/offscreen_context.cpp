#include "picture/offscreen_context.h"

#include <dlfcn.h>

#include <array>
#include <string>
#include <vector>

#include <epoxy/egl.h>

#include "picture/picture_error.h"

namespace hooke::picture {
namespace {

constexpr const char* remedy =
    "install OpenGL, EGL and a driver (Debian: libgl1, libegl1 and libgl1-mesa-dri, which can draw without a "
    "graphics card)";

bool has_library(const char* name) {
  void* const library = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
  if (library) dlclose(library);
  return library != nullptr;
}

/// libepoxy ends the program where it does not find these, so they are looked for first.
void require_libraries() {
  if (!has_library("libEGL.so.1"))
    throw PictureError(std::string("there is no EGL to draw pictures with: ") + remedy);
  if (!has_library("libOpenGL.so.0") && !has_library("libGL.so.1")) {
    throw PictureError(std::string("there is no OpenGL to draw pictures with: ") + remedy);
  }
}

bool offers(EGLDisplay display, const char* extension) {
  return epoxy_has_egl_extension(display, extension);
}

/// Displays to try, the best first: graphics cards, Mesa without any window system, and whatever is usual
/// here.
std::vector<EGLDisplay> displays() {
  std::vector<EGLDisplay> found;
  const auto add = [&](EGLDisplay display) {
    if (display != EGL_NO_DISPLAY) found.push_back(display);
  };
  if (offers(EGL_NO_DISPLAY, "EGL_EXT_platform_base")) {
    if (offers(EGL_NO_DISPLAY, "EGL_EXT_platform_device") &&
        (offers(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") ||
         offers(EGL_NO_DISPLAY, "EGL_EXT_device_base"))) {
      std::array<EGLDeviceEXT, 16> devices{};
      EGLint count = 0;
      eglQueryDevicesEXT(EGLint(devices.size()), devices.data(), &count);
      for (EGLint k = 0; k < count; ++k) {
        add(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[std::size_t(k)], nullptr));
      }
    }
    if (offers(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
      add(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    }
  }
  add(eglGetDisplay(EGL_DEFAULT_DISPLAY));
  return found;
}

/// A context of this display that needs no surface; none where it has no such.
EGLContext context_of(EGLDisplay display) {
  if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API) ||
      !offers(display, "EGL_KHR_surfaceless_context") || !offers(display, "EGL_KHR_create_context")) {
    return EGL_NO_CONTEXT;
  }
  constexpr EGLint wanted_config[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_DONT_CARE,
                                      EGL_NONE};
  EGLConfig config = EGL_NO_CONFIG_KHR;
  EGLint count = 0;
  if (!offers(display, "EGL_KHR_no_config_context") &&
      (!eglChooseConfig(display, wanted_config, &config, 1, &count) || count == 0)) {
    return EGL_NO_CONTEXT;
  }
  constexpr EGLint wanted_context[] = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                                       3,
                                       EGL_CONTEXT_MINOR_VERSION_KHR,
                                       3,
                                       EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                                       EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                                       EGL_NONE};
  return eglCreateContext(display, config, EGL_NO_CONTEXT, wanted_context);
}

}  // namespace

struct OffscreenContext::Parts {
  Parts(EGLDisplay display_, EGLContext context_) : display(display_), context(context_) {}
  // A display is the whole process's, so it is left initialised for others.
  ~Parts() { eglDestroyContext(display, context); }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  EGLDisplay display;
  EGLContext context;
};

OffscreenContext::OffscreenContext() {
  require_libraries();
  for (const EGLDisplay display : displays()) {
    if (const EGLContext context = context_of(display); context != EGL_NO_CONTEXT) {
      parts_ = std::make_unique<Parts>(display, context);
      return;
    }
  }
  throw PictureError(std::string("no driver here draws with OpenGL 3.3 without a screen: ") + remedy);
}

OffscreenContext::~OffscreenContext() = default;
OffscreenContext::OffscreenContext(OffscreenContext&&) noexcept = default;
OffscreenContext& OffscreenContext::operator=(OffscreenContext&&) noexcept = default;

struct OffscreenContext::Current::Before {
  EGLDisplay own_display, display;
  EGLContext context;
  EGLSurface draw, read;
};

OffscreenContext::Current::Current(const OffscreenContext& context)
    : before_(std::make_unique<Before>(Before{context.parts_->display, eglGetCurrentDisplay(),
                                              eglGetCurrentContext(), eglGetCurrentSurface(EGL_DRAW),
                                              eglGetCurrentSurface(EGL_READ)})) {
  eglBindAPI(EGL_OPENGL_API);
  if (!eglMakeCurrent(context.parts_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, context.parts_->context)) {
    throw PictureError("the OpenGL context for pictures cannot be used: is it in use on another thread?");
  }
}

OffscreenContext::Current::~Current() {
  if (before_->context == EGL_NO_CONTEXT) {
    eglMakeCurrent(before_->own_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  } else {
    eglMakeCurrent(before_->display, before_->draw, before_->read, before_->context);
  }
}

}  // namespace hooke::picture
