#include "viewer/quantity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace hooke::viewer {

std::string number(double value, int digits) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return text.data();
}

std::string grouped(std::size_t count) {
  std::string text = std::to_string(count);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, " ");
  return text;
}

std::string quantity(double value, std::string_view unit) {
  constexpr std::array prefixes{"p", "n", "\u00b5", "m", "", "k", "M", "G", "T"};
  constexpr int none = 4;
  if (value == 0.0 || !std::isfinite(value)) return number(value) + " " + std::string(unit);
  // Rounded first, so that 999.96 becomes 1 k and not 1000.
  const double rounded = std::stod(number(value));
  const int thousands = static_cast<int>(std::floor(std::log10(std::abs(rounded)) / 3.0 + 1e-9));
  const int prefix = std::clamp(thousands, -none, none);
  return number(rounded * std::pow(1000.0, -prefix)) + " " +
         prefixes[static_cast<std::size_t>(prefix + none)] + std::string(unit);
}

}  // namespace hooke::viewer
