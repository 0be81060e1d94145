#pragma once

#include <string>
#include <vector>

#include "picture/image.h"

struct GLFWwindow;

namespace hooke::viewer {

/// A key that was pressed: the character that it gives, or GLFW's number of a key that gives none.
struct KeyPress {
  unsigned character = 0;
  int key = 0;
};

/// A window to draw into with OpenGL 3.3. One at a time, and on the main thread only, as GLFW wants it.
class Window {
 public:
  /// Its context is current from here on. With `debug`, OpenGL is asked to report errors. Throws WindowError.
  Window(int width, int height, const std::string& title, bool debug);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* handle() const { return window_; }
  int width() const;   ///< [pixels] of its framebuffer
  int height() const;  ///< [pixels]
  /// Framebuffer's pixels for each of the units that the mouse is told in [1].
  double pixels_per_unit() const;
  /// How many times larger than usual text must be to be read on this screen [1].
  double content_scale() const;

  bool closing() const;
  void close();
  /// Keys that were pressed since the last call.
  std::vector<KeyPress> take_keys();
  /// Whether anything came from the user since the last call.
  bool take_activity();

  /// Waits for something to happen, at most `seconds` [s]; 0: does not wait.
  void poll(double seconds);
  /// Shows what was drawn.
  void swap();

  /// What was drawn and is not shown yet.
  picture::Image image() const;

  /// OpenGL's errors and complaints so far; empty where there are none.
  const std::vector<std::string>& complaints() const { return complaints_; }
  /// Asks OpenGL for its error, and notes it.
  void check();

 private:
  void listen();

  GLFWwindow* window_ = nullptr;
  std::vector<KeyPress> keys_;
  std::vector<std::string> complaints_;
  bool activity_ = true;
};

}  // namespace hooke::viewer
