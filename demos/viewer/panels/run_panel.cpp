#include <cstdio>

#include <imgui.h>

#include "viewer/actions.h"
#include "viewer/panels/action_button.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/parts.h"
#include "viewer/quantity.h"
#include "viewer/style.h"

namespace hooke::viewer {
namespace {

void buttons(State& state) {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - 2.0f * gap) / 3.0f;
  const bool running = state.moment().running;
  if (running) ImGui::PushStyleColor(ImGuiCol_Button, tone(palette::accent, 0.55f));
  action_button(state, running ? "Pause###pause" : "Run###pause", "pause", Action::toggle_running, width);
  if (running) ImGui::PopStyleColor();
  ImGui::SameLine();
  action_button(state, "Step", "step", Action::step, width);
  ImGui::SameLine();
  action_button(state, "Reset", "reset", Action::reset, width);
}

void speed_slider(State& state) {
  double speed = state.moment().speed;
  name_line("speed " + number(speed) + "x");
  // The number is beside it, as the grip would cover it.
  if (ImGui::SliderScalar("##speed", ImGuiDataType_Double, &speed, &slowest, &fastest, " ",
                          ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoInput))
    state.simulation.send(SetSpeed{speed});
  state.controls.note("speed");
}

/// What comes of the speed that is asked for.
void tell_pace(const Moment& moment) {
  const double ratio = moment.speeds.real_time_ratio;
  const bool behind = ratio < 0.95 * moment.speed;
  if (!moment.running) {
    tell("pace", "paused");
  } else if (ratio <= 0.0) {
    tell("pace", "");
  } else {
    tell("pace", number(behind ? ratio : moment.speed, 2) + "x real time",
         behind ? palette::warning : palette::text);
  }
}

}  // namespace

void run_panel(State& state) {
  const Moment& moment = state.moment();
  buttons(state);
  speed_slider(state);
  char time[64];
  std::snprintf(time, sizeof time, "%.3f s, step %llu", moment.time,
                static_cast<unsigned long long>(moment.steps));
  tell("time", time);
  tell_pace(moment);
  const double springs = moment.speeds.springs_per_second;
  if (moment.in_force->springs > 0)
    tell("springs", springs > 0.0 ? quantity(springs, "") + " each second" : "");
}

}  // namespace hooke::viewer
