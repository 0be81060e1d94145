#include <imgui.h>

#include "viewer/panels/panels.h"
#include "viewer/shortcuts.h"
#include "viewer/style.h"

namespace hooke::viewer {
namespace {

void line(const char* how, const char* what) {
  const float left = ImGui::GetCursorPosX();
  ImGui::PushStyleColor(ImGuiCol_Text, tone(palette::accent));
  ImGui::TextUnformatted(how);
  ImGui::PopStyleColor();
  ImGui::SameLine(left + 12.0f * ImGui::GetFontSize());
  ImGui::TextUnformatted(what);
}

}  // namespace

void help_window(State& state, float left) {
  if (!state.help) return;
  const ImVec2 all = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({left + 0.5f * (all.x - left), 0.5f * all.y}, ImGuiCond_Always, {0.5f, 0.5f});
  const int flags =
      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove;
  if (ImGui::Begin("help", nullptr, flags)) {
    for (const MouseHint& hint : mouse_hints()) line(hint.how, hint.what);
    ImGui::Separator();
    for (const Shortcut& shortcut : shortcuts()) {
      if (*shortcut.what != '\0') line(shortcut.keys, shortcut.what);
    }
  }
  ImGui::End();
}

}  // namespace hooke::viewer
