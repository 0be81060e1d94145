#include "viewer/style.h"

namespace hooke::viewer {
namespace {

void set_sizes(ImGuiStyle& style) {
  style.WindowPadding = {14.0f, 12.0f};
  style.FramePadding = {8.0f, 3.5f};
  style.ItemSpacing = {8.0f, 5.0f};
  style.ItemInnerSpacing = {6.0f, 4.0f};
  style.ScrollbarSize = 11.0f;
  style.GrabMinSize = 10.0f;
  style.WindowRounding = 6.0f;
  style.FrameRounding = 4.0f;
  style.GrabRounding = 4.0f;
  style.PopupRounding = 4.0f;
  style.ScrollbarRounding = 6.0f;
  style.WindowBorderSize = 0.0f;
  style.PopupBorderSize = 1.0f;
}

void set_colours(ImVec4* colours) {
  const auto set = [&](ImGuiCol which, const Colour& colour, float opacity = 1.0f) {
    colours[which] = tone(colour, opacity);
  };
  set(ImGuiCol_Text, palette::text);
  set(ImGuiCol_TextDisabled, palette::faint);
  set(ImGuiCol_WindowBg, {33, 36, 42});
  set(ImGuiCol_PopupBg, {40, 43, 50});
  set(ImGuiCol_Border, {66, 71, 82});
  set(ImGuiCol_FrameBg, {48, 52, 60});
  set(ImGuiCol_FrameBgHovered, {58, 63, 73});
  set(ImGuiCol_FrameBgActive, {66, 72, 84});
  set(ImGuiCol_Button, {58, 63, 74});
  set(ImGuiCol_ButtonHovered, {72, 79, 92});
  set(ImGuiCol_ButtonActive, palette::accent, 0.85f);
  set(ImGuiCol_Header, {33, 36, 42});
  set(ImGuiCol_HeaderHovered, {48, 52, 60});
  set(ImGuiCol_HeaderActive, {56, 61, 71});
  set(ImGuiCol_SliderGrab, palette::accent);
  set(ImGuiCol_SliderGrabActive, palette::accent);
  set(ImGuiCol_CheckMark, palette::accent);
  set(ImGuiCol_Separator, {58, 62, 71});
  set(ImGuiCol_ScrollbarBg, {33, 36, 42});
  set(ImGuiCol_ScrollbarGrab, {70, 75, 86});
  set(ImGuiCol_PlotHistogram, palette::accent);
  set(ImGuiCol_TitleBg, {40, 43, 50});
  set(ImGuiCol_TitleBgActive, {40, 43, 50});
}

}  // namespace

void set_style(float scale) {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  set_sizes(style);
  set_colours(style.Colors);
  style.ScaleAllSizes(scale);
}

}  // namespace hooke::viewer
