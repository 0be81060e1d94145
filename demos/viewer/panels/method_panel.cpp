#include <algorithm>
#include <string>
#include <thread>

#include <imgui.h>

#include "viewer/live/coefficients.h"
#include "viewer/panels/action_button.h"
#include "viewer/panels/coefficient_inputs.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/parts.h"
#include "viewer/style.h"

namespace hooke::viewer {
namespace {

/// A list to choose from. Its entries are noted as "name/entry" while it is open.
template <class Choices, class Value>
bool choose(State& state, const std::string& name, const Choices& choices, Value& value) {
  name_line(name);
  const std::string now(to_string(value));
  const bool open = ImGui::BeginCombo(("##" + name).c_str(), now.c_str(), ImGuiComboFlags_HeightLargest);
  state.controls.note(name);
  if (!open) return false;
  bool changed = false;
  for (const auto& choice : choices) {
    const std::string label(to_string(choice));
    if (ImGui::Selectable(label.c_str(), label == now) && label != now) {
      value = choice;
      changed = true;
    }
    state.controls.note(name + "/" + label);
  }
  ImGui::EndCombo();
  return changed;
}

bool step_input(State& state) {
  name_line("step");
  double milliseconds = 1e3 * state.wanted.settings.step;
  const bool changed = drag_number("##step", milliseconds, "ms");
  state.controls.note("step length");
  if (changed) state.wanted.settings.step = 1e-3 * milliseconds;
  return changed;
}

/// Nothing to choose where a host gives its own threads, or there is only one.
bool threads_input(State& state) {
  Settings& settings = state.wanted.settings;
  const int most = int(std::max(1u, std::thread::hardware_concurrency()));
  if (settings.executor || most == 1) return false;
  name_line("threads");
  int threads = settings.threads == 0 ? most : int(settings.threads);
  const bool changed = ImGui::InputInt("##threads", &threads);
  state.controls.note("threads");
  if (changed) settings.threads = unsigned(std::clamp(threads, 1, most));
  return changed;
}

/// Nothing to choose where there are no springs, or the method gathers only.
bool accumulation_input(State& state) {
  Settings& settings = state.wanted.settings;
  if (!can_accumulate(settings.method, settings.accumulation)) settings.accumulation = Accumulation::gather;
  if (state.moment().in_force->springs == 0 || solves_equations(settings.method)) return false;
  return choose(state, "accumulation", accumulations, settings.accumulation);
}

}  // namespace

void method_panel(State& state) {
  if (!section("Method")) return;
  bool changed = choose(state, "method", all_methods, state.wanted.settings.method);
  changed = coefficient_inputs(state, "method", coefficients_of(state.wanted.settings.method)) || changed;
  changed = step_input(state) || changed;
  changed = threads_input(state) || changed;
  changed = accumulation_input(state) || changed;
  if (changed) state.change();
  stability_gauge(state);
  action_button(state, "What would more accuracy cost?", "study", Action::toggle_study,
                ImGui::GetContentRegionAvail().x);
}

}  // namespace hooke::viewer
