#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace hooke {

/// What is wrong with a file and what to do about it; it does not say which file.
struct FileFault {
  std::string problem;
  std::string remedy;
};

/// Opens a file that someone else wrote. Throws FileFault where it is missing, is no ordinary file (a folder,
/// or a device that never ends), or is larger than 1 GiB.
std::ifstream open_input_file(const std::filesystem::path& file);

}  // namespace hooke
