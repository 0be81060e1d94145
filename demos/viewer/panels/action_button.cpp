#include "viewer/panels/action_button.h"

#include <imgui.h>

namespace hooke::viewer {

void action_button(State& state, const char* label, const std::string& name, Action action, float width) {
  if (ImGui::Button(label, {width, 1.75f * ImGui::GetFontSize()})) perform(action, state);
  state.controls.note(name);
}

}  // namespace hooke::viewer
