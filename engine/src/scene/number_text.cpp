#include "scene/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace hooke {

std::string to_text(double value) {
  if (std::isnan(value)) return "nan";  // to_chars would show its sign, which means nothing to a user
  std::array<char, 32> buffer;          // the longest, such as -1.7976931348623157e+308, has 24 characters
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

std::string rounded_down(double value) {
  if (!(value > 0.0)) return "0";
  if (std::isinf(value)) return "inf";
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 3.0);
  return to_text(std::floor(value / unit) * unit);
}

std::string to_text(const Vec3& value) {
  std::string text = "(";
  text.append(to_text(value.x()))
      .append(", ")
      .append(to_text(value.y()))
      .append(", ")
      .append(to_text(value.z()));
  return text += ')';
}

}  // namespace hooke
