#pragma once

#include <imgui.h>

#include "viewer/plot.h"

namespace hooke::viewer {

/// The viewer's colours.
namespace palette {
inline constexpr Colour accent{86, 156, 240}, good{98, 190, 124}, warning{236, 178, 80}, bad{232, 92, 88};
inline constexpr Colour text{228, 230, 235}, faint{148, 153, 164};
inline constexpr Colour plot_ground{24, 26, 31}, grid{52, 56, 64};
}  // namespace palette

inline ImU32 ink(const Colour& colour, float opacity = 1.0f) {
  return IM_COL32(colour[0], colour[1], colour[2], static_cast<int>(255.0f * opacity));
}
inline ImVec4 tone(const Colour& colour, float opacity = 1.0f) {
  return ImGui::ColorConvertU32ToFloat4(ink(colour, opacity));
}

/// Sets ImGui's colours and spaces, for an interface `scale` times its usual size [1].
void set_style(float scale);

}  // namespace hooke::viewer
