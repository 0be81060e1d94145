#include "picture/sheet.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <doctest/doctest.h>

#include "picture/label.h"
#include "picture/picture_error.h"

namespace hooke::picture {
namespace {

using Colour = std::array<std::uint8_t, 3>;

Image of_one_colour(int width, int height, const Colour& colour) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = colour[i % 3];
  return image;
}

Colour at(const Image& image, int column, int row) {
  const std::uint8_t* const pixel = image.pixel(column, row);
  return {pixel[0], pixel[1], pixel[2]};
}

std::size_t count(const Image& image, const Colour& colour) {
  std::size_t found = 0;
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) found += at(image, column, row) == colour ? 1 : 0;
  }
  return found;
}

constexpr Colour white{255, 255, 255};

TEST_CASE("every cell of a sheet is in its place, whole, and the sheet has the size asked for") {
  Sheet sheet(640, 361, 3, 2);
  const int width = sheet.cell_width(), height = sheet.cell_height();
  const auto colour_of = [](int cell) { return Colour{static_cast<std::uint8_t>(10 + 30 * cell), 60, 90}; };
  for (const int cell : {0, 1, 2, 3, 5}) sheet.place(cell, of_one_colour(width, height, colour_of(cell)), "");
  CHECK(sheet.image().width == 640);
  CHECK(sheet.image().height == 361);
  CHECK(3 * width > 0.97 * 640);
  CHECK(2 * height > 0.97 * 361);
  std::size_t covered = 0;
  for (const int cell : {0, 1, 2, 3, 5}) {
    CHECK(at(sheet.image(), 640 * (2 * (cell % 3) + 1) / 6, 361 * (2 * (cell / 3) + 1) / 4) ==
          colour_of(cell));
    CHECK(count(sheet.image(), colour_of(cell)) == static_cast<std::size_t>(width * height));
    covered += static_cast<std::size_t>(width * height);
  }
  CHECK(count(sheet.image(), white) == 640U * 361U - covered);
}

TEST_CASE("a sheet of one cell is the picture") {
  Sheet sheet(101, 77, 1, 1);
  Image image = of_one_colour(101, 77, {1, 2, 3});
  image.pixel(5, 6)[0] = 200;
  sheet.place(0, image, "");
  CHECK(sheet.image().rgb == image.rgb);
}

TEST_CASE("a sheet whose cells would be too small is refused with its numbers and a remedy") {
  CHECK_THROWS_WITH_AS(Sheet(100, 100, 20, 2), doctest::Contains("20x2"), PictureError);
  CHECK_THROWS_WITH_AS(Sheet(100, 100, 20, 2), doctest::Contains("larger --size"), PictureError);
  Sheet sheet(100, 100, 2, 2);
  CHECK_THROWS_AS(sheet.place(0, Image(100, 100), ""), std::invalid_argument);
}

TEST_CASE("a label is dark on light, in the lower left corner, and wholly within its cell") {
  constexpr Colour grey{128, 128, 128};
  for (const int size : {90, 240, 600}) {
    Sheet sheet(size, size, 1, 1);
    sheet.place(0, of_one_colour(size, size, grey), "12.34 s");
    const Image& image = sheet.image();
    int left = size, right = -1, top = size, bottom = -1, darkest = 255, lightest = 0;
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        if (at(image, column, row) == grey) continue;
        left = std::min(left, column), right = std::max(right, column);
        top = std::min(top, row), bottom = std::max(bottom, row);
        darkest = std::min(darkest, int{at(image, column, row)[0]});
        lightest = std::max(lightest, int{at(image, column, row)[0]});
      }
    }
    CHECK(left > 0);
    CHECK(right < 0.6 * size);
    CHECK(top > 0.75 * size);
    CHECK(bottom < size - 1);
    CHECK(bottom - top >= 7);
    CHECK(darkest < 80);
    CHECK(lightest > 180);
  }
}

TEST_CASE("every digit is drawn, and no two alike") {
  std::vector<Image> drawn;
  for (const char digit : std::string("0123456789.s")) {
    Image image = of_one_colour(40, 40, white);
    write_label(image, std::string(1, digit), 8, 32, 24.0);
    CHECK(count(image, white) < 1590);
    for (const Image& other : drawn) CHECK(other.rgb != image.rgb);
    drawn.push_back(image);
  }
  CHECK(label_width("10 s", 24.0) == doctest::Approx(2.0 * label_width("10 s", 12.0)));
  CHECK(label_width("10 s", 24.0) > label_width("1 s", 24.0));
}

TEST_CASE("what of a label lies outside of the picture is left out, and other letters are refused") {
  Image image = of_one_colour(20, 20, white);
  write_label(image, "888888", -30, 30, 40.0);
  CHECK(count(image, white) < 400);
  CHECK_THROWS_WITH_AS(write_label(image, "x", 0, 10, 10.0), doctest::Contains("'x'"), std::invalid_argument);
}

}  // namespace
}  // namespace hooke::picture
