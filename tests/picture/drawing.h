#pragma once

#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "optional.h"
#include "picture/offscreen_context.h"
#include "picture/painter.h"
#include "picture/picture_error.h"
#include "surfaces.h"

/// What tests that draw share.

namespace hooke::test {

/// Whether pictures can be drawn here. Where not, says so, or fails where they must.
inline bool can_draw() {
  try {
    const picture::OffscreenContext context;
    return true;
  } catch (const picture::PictureError& error) {
    skip(std::string("no picture can be drawn: ") + error.what());
    return false;
  }
}

constexpr int width = 480, height = 270;
constexpr double aspect = double(width) / height;

/// Nothing but what a test asks for.
constexpr picture::Look nothing{
    .surface = false, .springs = false, .particles = false, .pins = false, .ground = false, .shadow = false};

inline picture::Subject subject_of(const Surface& surface) {
  picture::Subject subject;
  subject.particles = surface.corners();
  subject.triangles = surface.triangles;
  return subject;
}

/// One true or false for each pixel, row by row from the top.
using Mask = std::vector<char>;

inline double count(const Mask& mask) {
  double sum = 0.0;
  for (const char pixel : mask) sum += pixel;
  return sum;
}

/// The pixels that are not the same, by more than `least` of 255.
inline Mask difference(const picture::Image& a, const picture::Image& b, int least = 0) {
  REQUIRE(a.rgb.size() == b.rgb.size());
  Mask mask(a.rgb.size() / 3);
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    if (std::abs(int(a.rgb[i]) - int(b.rgb[i])) > least) mask[i / 3] = 1;
  }
  return mask;
}

/// Where a pixel of four samples usually has them.
constexpr double samples[4][2] = {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};

/// Whether a triangle of the picture has one of a pixel's samples within it.
inline bool touches(const Vec3& a, const Vec3& b, const Vec3& c, int column, int row) {
  const auto side = [](const Vec3& from, const Vec3& to, double x, double y) {
    return (to.x() - from.x()) * (y - from.y()) - (to.y() - from.y()) * (x - from.x());
  };
  for (const auto& [right, down] : samples) {
    const double x = column + right, y = row + down;
    const double ab = side(a, b, x, y), bc = side(b, c, x, y), ca = side(c, a, x, y);
    if ((ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0)) return true;
  }
  return false;
}

/// The pixels of which triangles cover a sample as the camera sees them, found without OpenGL. All corners
/// must be before the eye.
inline Mask covered(const Surface& surface, const picture::Camera& camera) {
  std::vector<Vec3> seen;
  for (std::size_t k = 0; k < surface.corners(); ++k) {
    const Vec3 place = camera.project(surface.corner(k), aspect);
    REQUIRE(place.z() > 0.0);
    seen.emplace_back((place.x() + 1.0) * width / 2.0, (1.0 - place.y()) * height / 2.0, 0.0);
  }
  Mask mask(std::size_t(width) * height);
  for (const Triangle& triangle : surface.triangles) {
    const Vec3 &a = seen[triangle[0]], &b = seen[triangle[1]], &c = seen[triangle[2]];
    const Vec3 least = a.cwiseMin(b).cwiseMin(c).cwiseMax(0.0), most = a.cwiseMax(b).cwiseMax(c);
    for (int row = int(least.y()); row <= std::min(height - 1, int(most.y())); ++row) {
      for (int column = int(least.x()); column <= std::min(width - 1, int(most.x())); ++column) {
        if (touches(a, b, c, column, row)) mask[std::size_t(row) * width + std::size_t(column)] = 1;
      }
    }
  }
  return mask;
}

/// The pixel where a point is seen.
inline const std::uint8_t* pixel_at(const picture::Image& image, const picture::Camera& camera,
                                    const Vec3& point) {
  const Vec3 place = camera.project(point, double(image.width) / image.height);
  const int column = int((place.x() + 1.0) / 2.0 * image.width),
            row = int((1.0 - place.y()) / 2.0 * image.height);
  REQUIRE(column >= 0);
  REQUIRE(column < image.width);
  REQUIRE(row >= 0);
  REQUIRE(row < image.height);
  return image.pixel(column, row);
}

inline int brightness(const std::uint8_t* pixel) {
  return pixel[0] + pixel[1] + pixel[2];
}

}  // namespace hooke::test
