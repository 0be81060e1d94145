#pragma once

#include <filesystem>
#include <string>
#include <system_error>

#include <stdlib.h>

#include "writers/atomic_file.h"

namespace hooke {

/// A new, empty folder that is removed with all that is in it.
class TemporaryFolder {
 public:
  /// Throws WriteError where it cannot be made.
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "hooke_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw WriteError(name, "the folder cannot be made");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace hooke
