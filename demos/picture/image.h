#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hooke::picture {

/// A picture in memory: red, green and blue of each pixel, one byte each (sRGB), row by row from the top.
struct Image {
  int width = 0, height = 0;        ///< [pixels]
  std::vector<std::uint8_t> rgb{};  ///< 3 * width * height

  Image() = default;
  Image(int width_, int height_)
      : width(width_), height(height_), rgb(3 * std::size_t(width_) * std::size_t(height_)) {}

  std::uint8_t* pixel(int column, int row) {
    return rgb.data() + 3 * (std::size_t(row) * std::size_t(width) + std::size_t(column));
  }
  const std::uint8_t* pixel(int column, int row) const {
    return const_cast<Image*>(this)->pixel(column, row);
  }
};

}  // namespace hooke::picture
