#include <imgui.h>

#include "viewer/panels/panels.h"
#include "viewer/panels/parts.h"

namespace hooke::viewer {
namespace {

void tick(State& state, const char* name, bool& value) {
  ImGui::Checkbox(name, &value);
  state.controls.note(name);
}

}  // namespace

void picture_panel(State& state) {
  if (!section("Picture")) return;
  picture::Look& look = state.view.look();
  const float second = 0.5f * ImGui::GetContentRegionAvail().x;
  const float left = ImGui::GetCursorPosX();
  if (!state.scene.triangles.empty()) {
    tick(state, "surface", look.surface);
    ImGui::SameLine(left + second);
  }
  tick(state, "particles", look.particles);
  if (state.moment().in_force->springs > 0) {
    tick(state, "springs", look.springs);
    if (!state.scene.pins.empty()) ImGui::SameLine(left + second);
  }
  if (!state.scene.pins.empty()) tick(state, "pins", look.pins);
}

}  // namespace hooke::viewer
