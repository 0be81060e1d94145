#include "viewer/column.h"

#include <string>

#include <imgui.h>

#include "viewer/panels/action_button.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/parts.h"
#include "viewer/quantity.h"
#include "viewer/style.h"

namespace hooke::viewer {
namespace {

void heading(State& state, const Interface& interface) {
  ImGui::PushFont(interface.title_font());
  const std::string& name = state.scene.name;
  ImGui::TextUnformatted(name.empty() ? "scene" : name.c_str());
  ImGui::PopFont();
  const float width = 1.75f * ImGui::GetFontSize();
  ImGui::SameLine(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - width);
  action_button(state, "?", "help", Action::toggle_help, width);
  const InForce& in_force = *state.moment().in_force;
  std::string counts = grouped(in_force.particles) + " particles";
  if (in_force.springs > 0) counts += ", " + grouped(in_force.springs) + " springs";
  remark(counts);
}

/// Words on the scene, at its lower left corner.
void hint(const State& state, float left) {
  const float font = ImGui::GetFontSize();
  const std::string text = state.notice.empty() ? "? lists what keys and mouse do" : state.notice;
  const ImVec2 at(left + font, ImGui::GetIO().DisplaySize.y - 2.0f * font);
  ImGui::GetBackgroundDrawList()->AddText(at, IM_COL32(40, 44, 52, 200), text.c_str());
}

}  // namespace

float column(State& state, const Interface& interface) {
  if (!state.panels) return 0.0f;
  const float width = 25.0f * ImGui::GetFontSize();
  ImGui::SetNextWindowPos({0.0f, 0.0f});
  ImGui::SetNextWindowSize({width, ImGui::GetIO().DisplaySize.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
  const int flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                    ImGuiWindowFlags_NoBringToFrontOnFocus;
  if (ImGui::Begin("panels", nullptr, flags)) {
    heading(state, interface);
    run_panel(state);
    energy_panel(state);
    method_panel(state);
    effects_panel(state);
    stages_panel(state);
    picture_panel(state);
  }
  ImGui::End();
  ImGui::PopStyleVar();
  return width;
}

void overlays(State& state, float left) {
  hint(state, left);
  banner(state, left);
  study_window(state, left);
  help_window(state, left);
}

}  // namespace hooke::viewer
