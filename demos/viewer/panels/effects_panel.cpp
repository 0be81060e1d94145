#include <map>
#include <string>
#include <vector>

#include <imgui.h>

#include "viewer/live/coefficients.h"
#include "viewer/panels/coefficient_inputs.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/parts.h"

namespace hooke::viewer {
namespace {

bool has_coefficients(std::vector<Effect>& effects) {
  for (Effect& effect : effects) {
    if (!coefficients_of(effect).empty()) return true;
  }
  return false;
}

/// An effect with one coefficient takes one line, under its own name.
bool effect_inputs(State& state, const std::string& name, const std::vector<Coefficient>& coefficients) {
  if (coefficients.empty()) return false;
  if (coefficients.size() == 1) {
    const Coefficient& only = coefficients.front();
    const bool changed = coefficient_input("##" + name, spelled(name), only);
    state.controls.note(name + "/" + only.name);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", spelled(only.name).c_str());
    return changed;
  }
  ImGui::TextUnformatted(spelled(name).c_str());
  return coefficient_inputs(state, name, coefficients);
}

}  // namespace

void effects_panel(State& state) {
  if (!has_coefficients(state.wanted.effects) || !section("Effects")) return;
  std::map<std::string, int> count;  // an effect may be named several times
  bool changed = false;
  for (Effect& effect : state.wanted.effects) {
    std::string name(name_of(effect));
    if (const int before = count[name]++; before > 0) name += " " + std::to_string(before + 1);
    changed = effect_inputs(state, name, coefficients_of(effect)) || changed;
  }
  if (changed) state.change();
}

}  // namespace hooke::viewer
