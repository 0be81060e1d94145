// Particles and pins.

#include "drawing.h"

using namespace hooke;
using namespace hooke::picture;
using namespace hooke::test;

namespace {

/// Three particles in a row, the last of them pinned.
struct Row {
  Row() {
    subject.particles = 3;
    subject.pins = {2};
  }
  Image paint(bool particles, bool pins) const {
    Look look = nothing;
    look.particles = particles;
    look.pins = pins;
    return Painter(subject, width, height).paint(positions, camera, look);
  }

  Subject subject;
  std::vector<float> positions = {-1, 0, 0, 0, 0, 0, 1, 0, 0};
  Camera camera{.azimuth = 0.0, .elevation = 0.0, .distance = 5.0};
};

}  // namespace

TEST_CASE("particles show as round points where they are") {
  if (!can_draw()) return;
  const Row row;
  const Image image = row.paint(true, false), empty = row.paint(false, false);
  const Mask differs = difference(image, empty);
  for (const double x : {-1.0, 0.0, 1.0}) {
    CHECK(brightness(pixel_at(image, row.camera, Vec3(x, 0, 0))) <
          brightness(pixel_at(empty, row.camera, Vec3(x, 0, 0))) - 60);
  }
  CHECK(brightness(pixel_at(image, row.camera, Vec3(0.5, 0, 0))) ==
        brightness(pixel_at(empty, row.camera, Vec3(0.5, 0, 0))));
  // A disc's area is pi/4 of the square around it.
  int left = width, right = 0;
  double area = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = width / 2 - 30; x < width / 2 + 30; ++x) {
      if (!differs[std::size_t(y) * width + std::size_t(x)]) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      ++area;
    }
  }
  const double across = right - left + 1;
  CHECK(across >= 5);
  CHECK(area == doctest::Approx(0.785 * across * across).epsilon(0.2));
}

TEST_CASE("a pin is larger and darker than a particle") {
  if (!can_draw()) return;
  const Row row;
  const Image particles = row.paint(true, false), both = row.paint(true, true),
              empty = row.paint(false, false);
  const double one_particle = count(difference(particles, empty)) / 3.0;
  const double pinned = count(difference(both, empty)) - 2.0 * one_particle;
  CHECK(pinned > 1.3 * one_particle);
  CHECK(brightness(pixel_at(both, row.camera, Vec3(1, 0, 0))) <
        brightness(pixel_at(particles, row.camera, Vec3(1, 0, 0))));
}

TEST_CASE("what is in front hides what is behind") {
  if (!can_draw()) return;
  const Row row;
  Surface wall = sheet(2, 2, [](double u, double v) { return Vec3(4 * u - 2, 4 * v - 2, 0.5); });
  Subject subject = subject_of(wall);
  subject.pins = {0};
  wall.positions[0] = wall.positions[1] = wall.positions[2] =
      0.0f;  // a corner of no triangle, behind the wall
  subject.triangles = {{1, 3, 2}};
  Look look = nothing;
  look.surface = true;
  Painter painter(subject, width, height);
  const Image without = painter.paint(wall.positions, row.camera, look);
  look.pins = true;
  CHECK(painter.paint(wall.positions, row.camera, look).rgb != without.rgb);  // beside the triangle
  wall.positions[0] = wall.positions[1] = 0.6f;
  CHECK(painter.paint(wall.positions, row.camera, look).rgb == without.rgb);  // behind it
}
