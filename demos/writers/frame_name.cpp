#include "writers/frame_name.h"

namespace hooke {

std::string frame_name(std::string_view name, std::size_t frame, std::string_view extension) {
  constexpr std::size_t least_digits = 4;
  std::string digits = std::to_string(frame);
  if (digits.size() < least_digits) digits.insert(0, least_digits - digits.size(), '0');
  return std::string(name) + "_" + digits + std::string(extension);
}

}  // namespace hooke
