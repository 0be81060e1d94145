#pragma once

#include <map>
#include <optional>
#include <string>

namespace hooke::viewer {

/// A part of the window, in the units of the mouse.
struct Rectangle {
  float left = 0.0f, top = 0.0f, right = 0.0f, bottom = 0.0f;
};

/// Where the controls of the last frame are: for who operates them without hands, as tests do.
class ControlMap {
 public:
  void begin_frame();
  /// Notes the control that ImGui drew last.
  void note(const std::string& name);
  void note(const std::string& name, const Rectangle& rectangle) { rectangles_[name] = rectangle; }

  std::optional<Rectangle> find(const std::string& name) const;

 private:
  std::map<std::string, Rectangle> rectangles_;
};

}  // namespace hooke::viewer
