#include <imgui.h>

#include "viewer/panels/action_button.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/parts.h"
#include "viewer/style.h"

namespace hooke::viewer {

namespace {

/// A window over the whole width of the scene, which holds what `draw` draws.
template <class Draw>
void band(const char* name, float left, float top, const Colour& colour, const Draw& draw) {
  const float font = ImGui::GetFontSize(), room = ImGui::GetIO().DisplaySize.x - left;
  ImGui::SetNextWindowPos({left + font, top});
  ImGui::SetNextWindowSize({room - 2.0f * font, 0.0f});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, tone(colour));
  ImGui::PushStyleColor(ImGuiCol_Button, tone({255, 255, 255}, 0.2f));
  if (ImGui::Begin(name, nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove)) draw();
  ImGui::End();
  ImGui::PopStyleColor(2);
}

constexpr Colour white{255, 255, 255}, red{150, 38, 38}, brown{140, 88, 20};

}  // namespace

void banner(State& state, float left) {
  const float top = ImGui::GetFontSize();
  const Moment& moment = state.moment();
  if (!moment.problem.empty()) {
    band("problem", left, top, red, [&] {
      coloured(white, "The run stopped: " + moment.problem + ".");
      action_button(state, "Reset", "problem/reset", Action::reset, 6.0f * ImGui::GetFontSize());
    });
  } else if (!moment.refusal.empty()) {
    band("refusal", left, top, brown, [&] { coloured(white, "Not changed: " + moment.refusal); });
  }
}

}  // namespace hooke::viewer
