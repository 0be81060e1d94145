#include "scene_file/input_file.h"

#include <cstdint>
#include <system_error>

namespace hooke {

std::ifstream open_input_file(const std::filesystem::path& file) {
  constexpr std::uintmax_t largest = std::uintmax_t{1} << 30;
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw FileFault{"does not exist", "give the path of a file that does"};
  if (std::filesystem::is_directory(status)) throw FileFault{"is a folder", "give the path of a file in it"};
  if (!std::filesystem::is_regular_file(status))
    throw FileFault{"is not an ordinary file", "give the path of one"};

  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (!error && size > largest)
    throw FileFault{"is larger than 1 GiB (" + std::to_string(size) + " bytes)", "give a smaller file"};
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw FileFault{"cannot be opened", "make it readable"};
  return stream;
}

}  // namespace hooke
