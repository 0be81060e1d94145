#pragma once

#include <filesystem>
#include <stdexcept>

#include <png.h>

#include "picture/image.h"

namespace hooke::test {

inline picture::Image read_png(const std::filesystem::path& file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&png, file.c_str())) throw std::runtime_error(png.message);
  png.format = PNG_FORMAT_RGB;
  picture::Image image(static_cast<int>(png.width), static_cast<int>(png.height));
  if (!png_image_finish_read(&png, nullptr, image.rgb.data(), 0, nullptr))
    throw std::runtime_error(png.message);
  return image;
}

/// A part of a picture.
inline picture::Image part_of(const picture::Image& image, int left, int top, int width, int height) {
  picture::Image part(width, height);
  for (int row = 0; row < height; ++row)
    std::copy_n(image.pixel(left, top + row), 3 * width, part.pixel(0, row));
  return part;
}

}  // namespace hooke::test
