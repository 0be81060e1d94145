#pragma once

#include "viewer/window.h"

struct ImFont;

namespace hooke::viewer {

/// Dear ImGui in a window: its context, fonts and style, for as long as it lives.
class Interface {
 public:
  explicit Interface(Window& window);
  ~Interface();
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  void begin_frame();
  /// Draws what was asked for since begin_frame() over what is in the window.
  void end_frame();

  /// How many times larger than usual everything is, in the units of the mouse [1].
  float scale() const { return scale_; }
  ImFont* title_font() const { return title_; }

 private:
  void load_fonts(double pixels_per_unit);

  float scale_;
  ImFont* title_ = nullptr;
};

}  // namespace hooke::viewer
