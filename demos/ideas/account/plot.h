#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace hooke::ideas {

struct Curve {
  std::string title;  ///< in the key; empty: not in it
  std::string style;  ///< in gnuplot's words, such as "lines linecolor rgb '#808080'"
  std::vector<std::array<double, 2>> points{};
};

/// Curves over the same axes.
struct Panel {
  std::string title;
  std::vector<Curve> curves;
};

/// Draws panels, `columns` of them in a row, into one PNG of 960 x 540 pixels by gnuplot. `settings` hold for
/// all, in gnuplot's words. An empty `file` means that none was asked for. Throws picture::PictureError where
/// it cannot be made, saying why.
void plot(const std::filesystem::path& file, const std::string& settings, const std::vector<Panel>& panels,
          int columns = 1);

}  // namespace hooke::ideas
