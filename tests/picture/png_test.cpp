#include "picture/png_file.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include <png.h>

#include "writers/atomic_file.h"

using namespace hooke;
using namespace hooke::picture;

namespace {

std::filesystem::path file_named(const std::string& name) {
  return std::filesystem::temp_directory_path() / ("hooke_" + name);
}

/// As libpng reads it.
Image read(const std::filesystem::path& file) {
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_file(&header, file.c_str()));
  header.format = PNG_FORMAT_RGB;
  Image image(int(header.width), int(header.height));
  REQUIRE(png_image_finish_read(&header, nullptr, image.rgb.data(), 0, nullptr));
  return image;
}

Image pattern(int width, int height) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = std::uint8_t((i * i + 7 * i) % 251);
  return image;
}

}  // namespace

TEST_CASE("a PNG file reads back as the same pixels") {
  const auto file = file_named("round_trip.png");
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(7, 5), std::pair(640, 360)}) {
    const Image image = pattern(width, height);
    write_png(file, image);
    const Image back = read(file);
    CHECK(back.width == width);
    CHECK(back.height == height);
    CHECK(back.rgb == image.rgb);
  }
  std::filesystem::remove(file);
}

TEST_CASE("a PNG file that cannot be written is an error that names it, and leaves nothing behind") {
  const auto file = std::filesystem::path("/nowhere/at/all/picture.png");
  try {
    write_png(file, pattern(3, 3));
    FAIL("no error");
  } catch (const WriteError& error) {
    CHECK(std::string(error.what()).find("/nowhere/at/all/picture.png") != std::string::npos);
  }
}

TEST_CASE("a picture without pixels, or with the wrong number of them, is not written") {
  const auto file = file_named("none.png");
  CHECK_THROWS_AS(write_png(file, Image()), WriteError);
  Image image = pattern(4, 4);
  image.rgb.pop_back();
  CHECK_THROWS_AS(write_png(file, image), WriteError);
  CHECK_FALSE(std::filesystem::exists(file));
}
