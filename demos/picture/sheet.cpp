#include "picture/sheet.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "picture/label.h"
#include "picture/picture_error.h"

namespace hooke::picture {
namespace {

constexpr int least_cell = 16;  // [pixels]

}  // namespace

Sheet::Sheet(int width, int height, int columns, int rows)
    : columns_(columns), gap_(std::clamp(std::min(width, height) / 180, 2, 12)), image_(width, height) {
  const int across = width - (columns - 1) * gap_, down = height - (rows - 1) * gap_;
  cell_width_ = across / columns;
  cell_height_ = down / rows;
  if (cell_width_ < least_cell || cell_height_ < least_cell)
    throw PictureError("a sheet of " + std::to_string(columns) + "x" + std::to_string(rows) +
                       " pictures does not fit into " + std::to_string(width) + "x" + std::to_string(height) +
                       " pixels; give a larger --size, or fewer columns and rows");
  left_ = across % columns / 2;
  top_ = down % rows / 2;
  std::fill(image_.rgb.begin(), image_.rgb.end(), std::uint8_t{255});
}

void Sheet::place(int cell, const Image& picture, std::string_view label) {
  if (picture.width != cell_width_ || picture.height != cell_height_)
    throw std::invalid_argument("Sheet::place: a picture of another size than the cells");
  Image written = picture;
  if (!label.empty()) {
    const double height = std::clamp(cell_height_ / 22.0, 7.0, 36.0);
    const int margin = static_cast<int>(1.2 * height);
    write_label(written, label, margin, cell_height_ - margin, height);
  }
  const int column = left_ + cell % columns_ * (cell_width_ + gap_);
  const int row = top_ + cell / columns_ * (cell_height_ + gap_);
  for (int y = 0; y < cell_height_; ++y)
    std::copy_n(written.pixel(0, y), 3 * cell_width_, image_.pixel(column, row + y));
}

}  // namespace hooke::picture
