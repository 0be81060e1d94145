#include <algorithm>

#include <imgui.h>

#include "viewer/panels/panels.h"
#include "viewer/panels/parts.h"
#include "viewer/plot_drawing.h"
#include "viewer/quantity.h"
#include "viewer/study_control.h"
#include "viewer/study_plot.h"
#include "viewer/style.h"

namespace hooke::viewer {
namespace {

void show_progress(State& state) {
  const double share = state.study.running->share();
  remark(
      "Every method at many steps, each against a reference that is checked by a second one. The "
      "simulation stands still meanwhile, so that the times are right.");
  bar(share, palette::accent, "studying " + number(state.study.seconds) + " s of the scene",
      number(100.0 * share, 2) + " %");
  if (ImGui::Button("Cancel")) close_study(state);
  state.controls.note("study/cancel");
}

void show_result(State& state) {
  const StudyThread& thread = *state.study.running;
  if (!thread.problem().empty()) {
    coloured(palette::bad, thread.problem());
  } else {
    const Plot plot = study_plot(thread.study());
    if (!plot.curves.empty()) {
      draw_plot(plot, 23.0f * ImGui::GetFontSize());
      draw_legend(plot);
    }
    ImGui::Separator();
    coloured(palette::text, thread.study().answer.text);
    remark(thread.study().reference.verdict);
  }
  if (ImGui::Button("Again")) start_study(state);
  state.controls.note("study/again");
  ImGui::SameLine();
  if (ImGui::Button("Close")) close_study(state);
  state.controls.note("study/close");
}

}  // namespace

void study_window(State& state, float left) {
  if (!state.study.shown || !state.study.running) return;
  const ImVec2 all = ImGui::GetIO().DisplaySize;
  const float font = ImGui::GetFontSize(), room = all.x - left;
  const float width = std::min(46.0f * font, room - 2.0f * font);
  ImGui::SetNextWindowPos({left + 0.5f * room, 0.5f * all.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, all.y - 2.0f * font});
  const int flags = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize |
                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoTitleBar;
  if (ImGui::Begin("study", nullptr, flags)) {
    ImGui::TextUnformatted("What would more accuracy cost?");
    ImGui::Separator();
    if (state.study.running->done()) {
      show_result(state);
    } else {
      show_progress(state);
    }
  }
  ImGui::End();
}

}  // namespace hooke::viewer
