#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// What a plot shows, as plain data; plot_drawing.h draws it.

namespace hooke::viewer {

/// Red, green and blue.
using Colour = std::array<std::uint8_t, 3>;

struct Axis {
  double low = 0.0, high = 1.0;
  bool logarithmic = false;
  std::string label = {};

  /// Where a value lies between low (0) and high (1).
  double place(double value) const;
};

enum class Marker { none, circle, square, diamond, triangle, cross, plus, ring, nabla };

struct Curve {
  std::string label = {};
  Colour colour{};
  Marker marker = Marker::none;
  std::vector<double> x, y;  ///< joined by lines; a value that is not finite makes a gap
  std::vector<double> single_x = {}, single_y = {};  ///< further points, joined to nothing
};

/// A line across the plot at a value of x, with a word at its top.
struct Mark {
  double x = 0.0;
  std::string label = {};
};

struct Plot {
  Axis x, y;
  std::vector<Curve> curves;
  std::vector<Mark> marks;
};

/// Round numbers in [low, high], `most` at most (and at least two where that can be done).
std::vector<double> ticks(const Axis& axis, int most);

}  // namespace hooke::viewer
