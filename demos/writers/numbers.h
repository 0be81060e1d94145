#pragma once

#include <algorithm>
#include <bit>
#include <charconv>
#include <limits>
#include <string>

/// How numbers get into files.

namespace hooke {

// Binary files get the numbers as they lie in memory, and all of their formats are read as little-endian.
static_assert(std::endian::native == std::endian::little, "the writers need a little-endian machine");

/// The nearest Real that is finite: a reader may refuse a file with an infinity in it.
template <class Real>
Real finite(double value) {
  constexpr double limit = std::numeric_limits<Real>::max();
  return static_cast<Real>(std::clamp(value, -limit, limit));
}

/// Appends the shortest text that reads back as the same number.
template <class Number>
void append_number(std::string& text, Number number) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
}

}  // namespace hooke
