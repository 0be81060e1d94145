#include "viewer/panels/coefficient_inputs.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "viewer/panels/parts.h"

namespace hooke::viewer {
namespace {

bool vector_input(const std::string& id, Vec3& value) {
  const float speed = float(std::max(1e-2 * value.norm(), 1e-5));
  return ImGui::DragScalarN(id.c_str(), ImGuiDataType_Double, value.data(), 3, speed, nullptr, nullptr,
                            "%.3g", ImGuiSliderFlags_NoRoundToFormat);
}

/// A count, of one at least.
bool count_input(const std::string& id, std::uint64_t& value) {
  constexpr std::uint64_t least = 1, most = 1000;
  return ImGui::DragScalar(id.c_str(), ImGuiDataType_U64, &value, 0.1f, &least, &most, nullptr,
                           ImGuiSliderFlags_AlwaysClamp);
}

}  // namespace

bool coefficient_input(const std::string& id, const std::string& label, const Coefficient& coefficient) {
  const std::string unit(coefficient.unit);
  if (auto* const* const value = std::get_if<Vec3*>(&coefficient.value)) {
    name_line(label + (unit.empty() ? "" : " [" + unit + "]"));
    return vector_input(id, **value);
  }
  name_line(label);
  if (auto* const* const count = std::get_if<std::uint64_t*>(&coefficient.value))
    return count_input(id, **count);
  return drag_number(id, *std::get<double*>(coefficient.value), unit);
}

bool coefficient_inputs(State& state, const std::string& owner,
                        const std::vector<Coefficient>& coefficients) {
  bool changed = false;
  for (const Coefficient& one : coefficients) {
    changed = coefficient_input("##" + owner + "/" + one.name, spelled(one.name), one) || changed;
    state.controls.note(owner + "/" + one.name);
  }
  return changed;
}

}  // namespace hooke::viewer
