#include "picture/label.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace hooke::picture {
namespace {

using Point = Eigen::Vector2d;

/// What a pen draws without being lifted. Digits are 6 high, on a line at 0; y goes up.
using Stroke = std::vector<Point>;

struct Glyph {
  double width = 4.0;
  std::vector<Stroke> strokes;
};

/// Part of an ellipse; angles in degrees, counter-clockwise from the right.
Stroke arc(const Point& centre, const Point& radii, double from, double to) {
  constexpr int parts = 32;
  Stroke stroke;
  for (int i = 0; i <= parts; ++i) {
    const double angle = (from + (to - from) * i / parts) * std::numbers::pi / 180.0;
    stroke.push_back(centre + radii.cwiseProduct(Point(std::cos(angle), std::sin(angle))));
  }
  return stroke;
}

Stroke followed_by(Stroke stroke, const Stroke& more) {
  stroke.insert(stroke.end(), more.begin(), more.end());
  return stroke;
}

/// The same upside down: a 9 for a 6.
Stroke turned(Stroke stroke) {
  for (Point& point : stroke) point = Point(4.0, 6.0) - point;
  return stroke;
}

Glyph glyph(char character) {
  const Stroke six_bowl = arc({2.0, 1.9}, {1.9, 1.9}, 0.0, 360.0);
  const Stroke six_stem{{2.75, 6.0}, {0.35, 2.85}};
  switch (character) {
    case '0':
      return {4.0, {arc({2.0, 3.0}, {1.9, 3.0}, 0.0, 360.0)}};
    case '1':
      return {4.0, {{{0.8, 4.6}, {2.4, 6.0}, {2.4, 0.0}}}};
    case '2':
      return {4.0, {followed_by(arc({2.0, 4.2}, {1.8, 1.8}, 165.0, -35.0), {{0.2, 0.0}, {3.9, 0.0}})}};
    case '3':
      return {4.0,
              {followed_by(arc({1.9, 4.55}, {1.55, 1.45}, 150.0, -90.0), {{1.4, 3.1}}),
               arc({1.9, 1.55}, {1.9, 1.55}, 90.0, -150.0)}};
    case '4':
      return {4.0, {{{3.1, 0.0}, {3.1, 6.0}, {0.0, 1.7}, {4.0, 1.7}}}};
    case '5':
      return {4.0,
              {followed_by({{3.6, 6.0}, {0.7, 6.0}, {0.45, 3.15}},
                           arc({1.95, 1.95}, {1.95, 1.95}, 140.0, -150.0))}};
    case '6':
      return {4.0, {six_bowl, six_stem}};
    case '7':
      return {4.0, {{{0.1, 6.0}, {3.9, 6.0}, {1.5, 0.0}}}};
    case '8':
      return {4.0, {arc({2.0, 4.55}, {1.55, 1.45}, 0.0, 360.0), arc({2.0, 1.55}, {1.9, 1.55}, 0.0, 360.0)}};
    case '9':
      return {4.0, {turned(six_bowl), turned(six_stem)}};
    case '.':
      return {0.6, {{{0.3, 0.0}, {0.3, 0.0}}}};
    case ' ':
      return {1.2, {}};
    case 's':
      return {2.8,
              {followed_by(arc({1.4, 3.05}, {1.2, 1.0}, 35.0, 250.0),
                           arc({1.4, 1.0}, {1.3, 1.05}, 70.0, -150.0))}};
    default:
      throw std::invalid_argument("write_label: '" + std::string(1, character) +
                                  "' cannot be written; give digits, points, spaces and s");
  }
}

constexpr double pen = 0.72, gap = 1.5;  // in the units of a glyph

/// The strokes of a text, moved to where they are in the picture.
std::vector<Stroke> strokes_of(std::string_view text, const Point& start, double scale) {
  std::vector<Stroke> result;
  double x = 0.0;
  for (const char character : text) {
    const Glyph drawn = glyph(character);
    for (Stroke stroke : drawn.strokes) {
      for (Point& point : stroke) point = start + scale * Point(x + point.x(), -point.y());
      result.push_back(stroke);
    }
    x += drawn.width + gap;
  }
  return result;
}

double distance(const Point& point, const Point& first, const Point& second) {
  const Point along = second - first;
  const double length = along.squaredNorm();
  const double share = length > 0.0 ? std::clamp((point - first).dot(along) / length, 0.0, 1.0) : 0.0;
  return (point - first - share * along).norm();
}

double distance(const Point& point, const Stroke& stroke) {
  double least = (point - stroke.front()).norm();
  for (std::size_t i = 1; i < stroke.size(); ++i)
    least = std::min(least, distance(point, stroke[i - 1], stroke[i]));
  return least;
}

void blend(std::uint8_t* pixel, double value, double share) {
  for (int k = 0; k < 3; ++k)
    pixel[k] = static_cast<std::uint8_t>(std::lround(pixel[k] + share * (value - pixel[k])));
}

/// Lays ink on the pixels that a stroke covers, in part at its edge.
void draw(Image& image, const Stroke& stroke, double radius, double value, double opacity) {
  Point low = stroke.front(), high = low;
  for (const Point& point : stroke) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const auto first = [radius](double bound) { return std::max(0, static_cast<int>(bound - radius - 1.0)); };
  const auto last = [radius](double bound, int size) {
    return std::min(size, static_cast<int>(bound + radius + 2.0));
  };
  for (int row = first(low.y()); row < last(high.y(), image.height); ++row) {
    for (int column = first(low.x()); column < last(high.x(), image.width); ++column) {
      const double inside = radius + 0.5 - distance(Point(column + 0.5, row + 0.5), stroke);
      if (inside > 0.0) blend(image.pixel(column, row), value, opacity * std::min(inside, 1.0));
    }
  }
}

}  // namespace

void write_label(Image& image, std::string_view text, int left, int baseline, double height) {
  constexpr double light = 255.0, dark = 40.0;
  const double scale = height / 6.0;
  const double radius = std::max(0.5 * pen * scale, 0.6);
  const std::vector<Stroke> strokes = strokes_of(text, Point(left, baseline), scale);
  for (const Stroke& stroke : strokes) draw(image, stroke, radius + 0.6 * scale, light, 0.7);
  for (const Stroke& stroke : strokes) draw(image, stroke, radius, dark, 1.0);
}

double label_width(std::string_view text, double height) {
  double width = 0.0;
  for (const char character : text) width += glyph(character).width + gap;
  return (width - gap) * height / 6.0;
}

}  // namespace hooke::picture
