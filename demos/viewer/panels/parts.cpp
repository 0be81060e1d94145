#include "viewer/panels/parts.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "viewer/style.h"

namespace hooke::viewer {
namespace {

float names_width() {
  return 8.2f * ImGui::GetFontSize();
}

/// Per cent signs have a meaning in formats.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '%' ? std::string("%%") : std::string(1, c);
  return result;
}

/// Returns its upper left corner.
ImVec2 draw_bar(double share, const Colour& colour, float height) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, height);
  ImGui::Dummy(size);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = std::min(ImGui::GetStyle().FrameRounding, 0.5f * height);
  list.AddRectFilled(low, {low.x + size.x, low.y + height}, ink(palette::plot_ground), rounding);
  const float filled = float(std::clamp(share, 0.0, 1.0)) * size.x;
  if (filled >= 1.0f) list.AddRectFilled(low, {low.x + filled, low.y + height}, ink(colour, 0.75f), rounding);
  return low;
}

/// Words from `at` on, and others up to `end` [units of the mouse].
void write_ends(ImVec2 at, float end, const std::string& left, const std::string& right) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText(at, ink(palette::text), left.c_str());
  list.AddText({end - ImGui::CalcTextSize(right.c_str()).x, at.y}, ink(palette::text), right.c_str());
}

}  // namespace

std::string spelled(std::string_view name) {
  std::string words(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

void name_line(const std::string& name) {
  const float left = ImGui::GetCursorPosX();
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, tone(palette::faint));
  ImGui::TextUnformatted(name.c_str());
  ImGui::PopStyleColor();
  ImGui::SameLine(left + names_width());
  ImGui::SetNextItemWidth(-1.0f);
}

void tell(const std::string& name, const std::string& value, const Colour& colour) {
  const float left = ImGui::GetCursorPosX();
  ImGui::PushStyleColor(ImGuiCol_Text, tone(palette::faint));
  ImGui::TextUnformatted(name.c_str());
  ImGui::PopStyleColor();
  ImGui::SameLine(left + names_width());
  coloured(colour, value);
}

bool section(const char* title) {
  const float font = ImGui::GetFontSize();
  ImGui::Dummy({0.0f, 0.1f * font});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.15f * font, 0.15f * font});
  const bool open = ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_DefaultOpen);
  ImGui::PopStyleVar();
  return open;
}

void remark(const std::string& text) {
  coloured(palette::faint, text);
}

void coloured(const Colour& colour, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, tone(colour));
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

void bar(double share, const Colour& colour, const std::string& left, const std::string& right) {
  const float font = ImGui::GetFontSize();
  const ImVec2 low = draw_bar(share, colour, 1.5f * font);
  const float y = low.y + 0.25f * font;
  write_ends({low.x + 0.5f * font, y}, low.x + ImGui::GetContentRegionAvail().x - 0.5f * font, left, right);
}

void gauge(double share, const Colour& colour, double mark, const std::string& left,
           const std::string& right) {
  const float font = ImGui::GetFontSize(), thick = 0.6f * font;
  const ImVec2 low = draw_bar(share, colour, thick);
  const float width = ImGui::GetContentRegionAvail().x, x = std::floor(low.x + float(mark) * width);
  ImGui::GetWindowDrawList()->AddLine({x, low.y - 2.0f}, {x, low.y + thick + 2.0f}, ink(palette::text), 2.0f);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::Dummy({width, font});
  write_ends(at, at.x + width, left, right);
}

bool drag_number(const std::string& id, double& value, const std::string& unit) {
  // A movement of 100 pixels doubles it; from zero on, steps are so small that it can be found again.
  const float speed = float(std::max(1e-2 * std::abs(value), 1e-5));
  const std::string format = "%.4g" + (unit.empty() ? "" : " " + escaped(unit));
  return ImGui::DragScalar(id.c_str(), ImGuiDataType_Double, &value, speed, nullptr, nullptr, format.c_str(),
                           ImGuiSliderFlags_NoRoundToFormat);
}

}  // namespace hooke::viewer
