#include "viewer/control_map.h"

#include <imgui.h>

namespace hooke::viewer {

void ControlMap::begin_frame() {
  rectangles_.clear();
}

void ControlMap::note(const std::string& name) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  note(name, {low.x, low.y, high.x, high.y});
}

std::optional<Rectangle> ControlMap::find(const std::string& name) const {
  const auto found = rectangles_.find(name);
  if (found == rectangles_.end()) return std::nullopt;
  return found->second;
}

}  // namespace hooke::viewer
