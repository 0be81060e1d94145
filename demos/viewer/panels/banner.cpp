#include <imgui.h>

#include "viewer/actions.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/parts.h"
#include "viewer/style.h"

namespace hooke::viewer {

void banner(State& state, float left) {
  const std::string& problem = state.moment().problem;
  if (problem.empty()) return;
  const float font = ImGui::GetFontSize(), room = ImGui::GetIO().DisplaySize.x - left;
  ImGui::SetNextWindowPos({left + font, font});
  ImGui::SetNextWindowSize({room - 2.0f * font, 0.0f});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, tone({150, 38, 38}));
  ImGui::PushStyleColor(ImGuiCol_Button, tone({190, 70, 66}));
  if (ImGui::Begin("problem", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove)) {
    coloured({255, 255, 255}, "The run stopped: " + problem + ".");
    if (ImGui::Button("Reset")) perform(Action::reset, state);
    state.controls.note("problem/reset");
  }
  ImGui::End();
  ImGui::PopStyleColor(2);
}

}  // namespace hooke::viewer
