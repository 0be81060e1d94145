#include "scene_file/scene_file.h"

#include <iterator>
#include <utility>

#include "scene_file/input_file.h"
#include "scene_file/json_reader.h"
#include "scene_file/json_text.h"
#include "scene_file/scene_reader.h"

namespace hooke {
namespace {

std::string list(std::string_view file, const std::vector<Fault>& faults) {
  constexpr std::size_t most_listed = 20;
  std::string text =
      std::string(file) + ": " + std::to_string(faults.size()) + (faults.size() == 1 ? " fault" : " faults");
  for (std::size_t i = 0; i < faults.size() && i < most_listed; ++i) text += "\n  " + faults[i].message();
  if (faults.size() > most_listed)
    text += "\n  ... and " + std::to_string(faults.size() - most_listed) + " more";
  return text;
}

SceneFile parse(std::string_view name, std::string_view json, const std::filesystem::path& folder,
                const SceneFileOptions& options) {
  std::vector<Fault> faults;
  SceneFile file;
  if (const auto root = parse_json(json, faults)) {
    JsonReader reader(faults, folder, options.max_particles);
    file = read_scene(reader, *root, folder, options);
  }
  if (!faults.empty()) throw SceneFileError(name, std::move(faults));
  return file;
}

}  // namespace

SceneFileError::SceneFileError(std::string_view file, std::vector<Fault> faults)
    : std::runtime_error(list(file, faults)), faults_(std::move(faults)) {}

SceneFile parse_scene(std::string_view json, const std::filesystem::path& folder,
                      const SceneFileOptions& options) {
  return parse("scene", json, folder, options);
}

SceneFile read_scene_file(const std::filesystem::path& file, const SceneFileOptions& options) {
  const std::string name = file.string();
  std::string text;
  try {
    std::ifstream stream = open_input_file(file);
    text.assign(std::istreambuf_iterator<char>(stream), {});
  } catch (const FileFault& fault) {
    throw SceneFileError(name, {{"file", fault.problem, fault.remedy}});
  }
  return parse(name, text, file.parent_path(), options);
}

}  // namespace hooke
