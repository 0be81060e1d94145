#include "viewer/saved_picture.h"

#include <cctype>
#include <exception>
#include <filesystem>

#include "picture/png_file.h"

namespace hooke::viewer {
namespace {

/// A scene's name as part of a file's name.
std::string file_name(const std::string& name) {
  std::string result;
  for (const char c : name) result += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return result.empty() ? "scene" : result;
}

std::filesystem::path free_file(const std::string& name) {
  for (int i = 1;; ++i) {
    const std::filesystem::path file = name + "_" + std::to_string(i) + ".png";
    if (!std::filesystem::exists(file)) return file;
  }
}

}  // namespace

std::string save_picture(const State& state) {
  try {
    const std::filesystem::path file = free_file(file_name(state.scene.name));
    picture::write_png(file, state.view.image());
    return "saved " + file.string();
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace hooke::viewer
