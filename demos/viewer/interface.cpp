#include "viewer/interface.h"

#include <array>
#include <filesystem>

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "viewer/style.h"

namespace hooke::viewer {
namespace {

/// Where systems keep a font that is easy to read on a screen; the first that is there is taken.
constexpr std::array fonts{
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
    "/System/Library/Fonts/Supplemental/Arial.ttf",
    "C:/Windows/Fonts/segoeui.ttf",
};

/// Empty where there is none of them.
const char* font_file() {
  for (const char* file : fonts) {
    std::error_code none;
    if (std::filesystem::exists(file, none)) return file;
  }
  return "";
}

ImFont* load(const char* file, float pixels) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  if (*file != '\0') return atlas.AddFontFromFileTTF(file, pixels);
  ImFontConfig config;
  config.SizePixels = pixels;  // ImGui's own
  return atlas.AddFontDefault(&config);
}

}  // namespace

Interface::Interface(Window& window) : scale_(float(window.content_scale() / window.pixels_per_unit())) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // no files beside the user's
  load_fonts(window.pixels_per_unit());
  set_style(scale_);
  ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

Interface::~Interface() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

/// Letters are made for the pixels of the framebuffer, and shown in the units of the mouse.
void Interface::load_fonts(double pixels_per_unit) {
  constexpr float text = 14.0f, title = 19.0f;
  const float pixels = scale_ * float(pixels_per_unit);
  const char* const file = font_file();
  load(file, text * pixels);
  title_ = load(file, title * pixels);
  ImGui::GetIO().FontGlobalScale = 1.0f / float(pixels_per_unit);
}

void Interface::begin_frame() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void Interface::end_frame() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace hooke::viewer
