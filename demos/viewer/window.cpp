#include "viewer/window.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "viewer/window_error.h"

namespace hooke::viewer {
namespace {

std::string last_glfw_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text == nullptr ? "no reason is given" : text;
}

constexpr const char* remedy =
    "; `hooke view` needs a display that draws with OpenGL 3.3; hooke run --picture FILE.png draws without "
    "one";

Window& window_of(GLFWwindow* handle) {
  return *static_cast<Window*>(glfwGetWindowUserPointer(handle));
}

void set_hints(bool debug) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);  // macOS gives a core profile only so
  glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, debug ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
}

void note_complaint(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* text,
                    const void* complaints) {
  // Hints about speed are not errors.
  if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
  auto& list = *static_cast<std::vector<std::string>*>(const_cast<void*>(complaints));
  list.emplace_back(text, static_cast<std::size_t>(std::max(0, length)));
}

}  // namespace

Window::Window(int width, int height, const std::string& title, bool debug) {
  if (glfwInit() == GLFW_FALSE) throw WindowError("there is no display: " + last_glfw_error() + remedy);
  set_hints(debug);
  window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (window_ == nullptr) {
    const std::string reason = last_glfw_error();
    glfwTerminate();
    throw WindowError("no window can be opened: " + reason + remedy);
  }
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  listen();
  if (debug && epoxy_has_gl_extension("GL_KHR_debug")) {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(note_complaint, &complaints_);
  }
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

void Window::listen() {
  glfwSetWindowUserPointer(window_, this);
  glfwSetCharCallback(window_, [](GLFWwindow* handle, unsigned character) {
    window_of(handle).keys_.push_back({character, 0});
    window_of(handle).activity_ = true;
  });
  glfwSetKeyCallback(window_, [](GLFWwindow* handle, int key, int, int action, int) {
    const bool gives_character = key < GLFW_KEY_ESCAPE;
    if (action != GLFW_RELEASE && !gives_character) window_of(handle).keys_.push_back({0, key});
    window_of(handle).activity_ = true;
  });
  glfwSetCursorPosCallback(window_,
                           [](GLFWwindow* handle, double, double) { window_of(handle).activity_ = true; });
  glfwSetMouseButtonCallback(window_,
                             [](GLFWwindow* handle, int, int, int) { window_of(handle).activity_ = true; });
  glfwSetScrollCallback(window_,
                        [](GLFWwindow* handle, double, double) { window_of(handle).activity_ = true; });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* handle) { window_of(handle).activity_ = true; });
}

int Window::width() const {
  int width = 0;
  glfwGetFramebufferSize(window_, &width, nullptr);
  return width;
}

int Window::height() const {
  int height = 0;
  glfwGetFramebufferSize(window_, nullptr, &height);
  return height;
}

double Window::pixels_per_unit() const {
  int units = 0;
  glfwGetWindowSize(window_, &units, nullptr);
  return units > 0 ? static_cast<double>(width()) / units : 1.0;
}

double Window::content_scale() const {
  float scale = 1.0f;
  glfwGetWindowContentScale(window_, &scale, nullptr);
  return scale > 0.0f ? scale : 1.0;
}

bool Window::closing() const {
  return glfwWindowShouldClose(window_) != GLFW_FALSE;
}

void Window::close() {
  glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

std::vector<KeyPress> Window::take_keys() {
  return std::exchange(keys_, {});
}

bool Window::take_activity() {
  return std::exchange(activity_, false);
}

void Window::poll(double seconds) {
  if (seconds > 0.0) {
    glfwWaitEventsTimeout(seconds);
  } else {
    glfwPollEvents();
  }
}

void Window::swap() {
  glfwSwapBuffers(window_);
}

picture::Image Window::image() const {
  picture::Image image(width(), height());
  std::vector<std::uint8_t> rgba(4 * std::size_t(image.width) * std::size_t(image.height));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  for (int row = 0; row < image.height; ++row) {  // OpenGL counts rows from below
    const std::uint8_t* from =
        rgba.data() + 4 * std::size_t(image.height - 1 - row) * std::size_t(image.width);
    std::uint8_t* to = image.pixel(0, row);
    for (int column = 0; column < image.width; ++column, from += 4, to += 3) std::copy_n(from, 3, to);
  }
  return image;
}

void Window::check() {
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR) complaints_.push_back("OpenGL error " + std::to_string(error));
}

}  // namespace hooke::viewer
