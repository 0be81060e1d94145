#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene_file/scene_file.h"

namespace hooke::test {

/// A scene file of one particle and a step, with these entries added: `"seconds": 2`.
inline std::string with(std::string_view entries) {
  return R"({"particles": {"mass": [1], "position": [[0, 0, 0]]}, "step": 0.01, )" + std::string(entries) +
         "}";
}

/// The faults of a scene file; none where it can be used.
inline std::vector<Fault> faults_of(std::string_view json, const SceneFileOptions& options = {}) {
  try {
    parse_scene(json, {}, options);
  } catch (const SceneFileError& error) {
    return error.faults();
  }
  return {};
}

/// The one fault of a scene file, as a user reads it; a list of all where there are not exactly one.
inline std::string fault_of(std::string_view json, const SceneFileOptions& options = {}) {
  const std::vector<Fault> faults = faults_of(json, options);
  if (faults.size() == 1) return faults[0].message();
  std::string text = std::to_string(faults.size()) + " faults:";
  for (const Fault& fault : faults) text += "\n" + fault.message();
  return text;
}

}  // namespace hooke::test
