// Surfaces: what they cover, that both sides are lit, that they change as a cloth falls, and that the same is
// drawn again.

#include <hooke/hooke.h>
#include <Eigen/Geometry>

#include "drawing.h"
#include "picture/light_direction.h"
#include "scenes.h"

using namespace hooke;
using namespace hooke::picture;
using namespace hooke::test;

namespace {

constexpr Look surface_alone{
    .surface = true, .springs = false, .particles = false, .pins = false, .ground = false, .shadow = false};

/// A square of 1 m x 1 m in the x-y plane, its front towards +z.
Surface square() {
  return sheet(9, 9, [](double u, double v) { return Vec3(u, v, 0.0); });
}

Surface turned(Surface surface, double angle, const Vec3& axis) {
  const Eigen::AngleAxisd turn(angle, axis.normalized());
  for (std::size_t k = 0; k < surface.corners(); ++k) {
    const Eigen::Vector3f x = (turn * surface.corner(k)).cast<float>();
    std::copy_n(x.data(), 3, surface.positions.begin() + std::ptrdiff_t(3 * k));
  }
  return surface;
}

struct Drawn {
  Image image;
  Mask differs;  ///< from the picture without the surface
};

Drawn drawn(const Surface& surface, const Camera& camera) {
  Painter painter(subject_of(surface), width, height);
  const Image empty = painter.paint(surface.positions, camera, nothing);
  Image image = painter.paint(surface.positions, camera, surface_alone);
  return {image, difference(image, empty)};
}

double mean_brightness(const Drawn& picture, const Mask& where) {
  double sum = 0.0;
  for (std::size_t i = 0; i < where.size(); ++i) {
    if (where[i]) sum += brightness(picture.image.rgb.data() + 3 * i);
  }
  return sum / count(where);
}

/// Both must cover as much, and differ at edges alone.
void check_coverage(const Mask& drawn_mask, const Mask& expected) {
  CHECK(count(drawn_mask) == doctest::Approx(count(expected)).epsilon(0.05));
  double wrong = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) wrong += drawn_mask[i] != expected[i];
  CHECK(wrong < 0.05 * count(expected));
}

std::vector<float> positions_of(const Simulation<float>& simulation) {
  std::vector<float> positions(3 * simulation.particle_count());
  simulation.copy_positions(positions.data(), 3 * sizeof(float));
  return positions;
}

}  // namespace

TEST_CASE("a square that faces the camera covers the area of a square") {
  if (!can_draw()) return;
  const Camera camera{.target = Vec3(0.5, 0.5, 0), .azimuth = 0.0, .elevation = 0.0, .distance = 2.0};
  const double metre = height / (2.0 * 2.0 * std::tan(0.3));  // [pixels]
  CHECK(count(drawn(square(), camera).differs) == doctest::Approx(metre * metre).epsilon(0.05));
}

TEST_CASE("squares, balls and draped sheets cover the pixels that their triangles do") {
  if (!can_draw()) return;
  const Surface wavy =
      sheet(40, 40, [](double u, double v) { return Vec3(u, 0.2 * std::sin(9 * u + 4 * v), v); });
  for (const Surface& surface : {square(), turned(square(), 1.1, Vec3(1, 2, 3)),
                                 turned(square(), 2.9, Vec3(0, 1, 0.2)), ball(48, 24), wavy}) {
    for (const double azimuth : {-1.0, 0.4, 2.5}) {
      const Camera camera = fitted({.azimuth = azimuth, .elevation = 0.5}, surface.positions, aspect);
      check_coverage(drawn(surface, camera).differs, covered(surface, camera));
    }
  }
}

TEST_CASE("a falling cloth covers what its triangles do, and looks different from moment to moment") {
  if (!can_draw()) return;
  const Scene scene = hung_cloth(24, 24);
  Simulation<float> simulation(scene, {.step = 1e-3});
  const Camera camera = fitted({}, positions_of(simulation), aspect, 0.2);
  Painter painter(picture::subject_of(scene), width, height);
  const Image empty = painter.paint(positions_of(simulation), camera, nothing);
  Image before = empty;
  for (int moment = 0; moment < 4; ++moment) {
    const std::vector<float> positions = positions_of(simulation);
    const Image image = painter.paint(positions, camera, surface_alone);
    check_coverage(difference(image, empty), covered({scene.triangles, positions}, camera));
    CHECK(count(difference(image, before)) > 500);
    before = image;
    REQUIRE(simulation.step(40).ok());
  }
}

TEST_CASE("both sides are lit, in colours of their own") {
  if (!can_draw()) return;
  const Surface upright = square();
  const Camera front = fitted({.azimuth = 0.3}, upright.positions, aspect);
  const Camera back = fitted({.azimuth = 0.3 + std::numbers::pi}, upright.positions, aspect);
  const Drawn one = drawn(upright, front), other = drawn(upright, back);
  CHECK(mean_brightness(one, covered(upright, front)) > 150.0);
  CHECK(mean_brightness(other, covered(upright, back)) > 150.0);
  const std::uint8_t* const front_pixel = pixel_at(one.image, front, Vec3(0.5, 0.5, 0));
  const std::uint8_t* const back_pixel = pixel_at(other.image, back, Vec3(0.5, 0.5, 0));
  CHECK(front_pixel[2] > front_pixel[0] + 40);  // blue-green
  CHECK(back_pixel[0] > back_pixel[2] + 20);    // sand
}

TEST_CASE("each side is brighter where that side faces the light") {
  if (!can_draw()) return;
  const Vec3 to_light = direction_to_light(Vec3(0, 1, 0));
  // Seen from the front, a square that leans back to the light, and one that leans forward, away from it.
  for (const bool front : {true, false}) {
    const auto leaning = [&](double angle) {
      const Surface upright = turned(square(), front ? 0.0 : std::numbers::pi, Vec3(0, 1, 0));
      const Surface surface = turned(upright, angle, Vec3(1, 0, 0));
      const Camera camera = fitted({.azimuth = 0.0, .elevation = 0.0}, surface.positions, aspect);
      return mean_brightness(drawn(surface, camera), covered(surface, camera));
    };
    CHECK(to_light.z() > 0.3);
    CHECK(leaning(-0.8) > leaning(0.8) + 80.0);
  }
}

TEST_CASE("a surface is brighter where it faces the light, and its shading is smooth") {
  if (!can_draw()) return;
  const Surface round = ball(48, 24);
  const Camera camera{.azimuth = 0.0, .elevation = 0.0, .distance = 4.0};
  const Image image = drawn(round, camera).image;
  const auto at = [&](const Vec3& place) { return brightness(pixel_at(image, camera, place)); };
  CHECK(at(Vec3(-0.3, 0.7, 0.65)) > at(Vec3(0.3, -0.7, 0.65)) + 60);
  // Along a meridian no two pixels side by side differ by more than a few: triangles of 7.5 degrees do not
  // show.
  for (double angle = -0.9; angle < 0.9; angle += 0.01) {
    const int here = at(Vec3(0.05, std::sin(angle), std::cos(angle)));
    const int there = at(Vec3(0.05, std::sin(angle + 0.01), std::cos(angle + 0.01)));
    CHECK(std::abs(here - there) <= 18);
  }
}

TEST_CASE("the same is drawn again, by the same painter and by another") {
  if (!can_draw()) return;
  const Scene scene = hung_cloth(16, 16);
  Simulation<float> simulation(scene, {.step = 1e-3});
  const std::vector<float> flat = positions_of(simulation);
  simulation.step(100);
  const std::vector<float> fallen = positions_of(simulation);
  const Camera camera = fitted({}, flat, aspect);
  Painter one(picture::subject_of(scene), width, height);
  const Image first = one.paint(fallen, camera, {});
  one.paint(flat, camera, surface_alone);
  CHECK(one.paint(fallen, camera, {}).rgb == first.rgb);
  Painter other(picture::subject_of(scene), width, height);
  CHECK(other.paint(fallen, camera, {}).rgb == first.rgb);
  CHECK(count(difference(first, Image(width, height))) == width * height);  // no pixel is left black
}

TEST_CASE("two painters may be used by turns, and one may be moved") {
  if (!can_draw()) return;
  const Surface one = square(), two = ball(24, 12);
  const Camera camera{.distance = 5.0};
  Painter painter(subject_of(one), width, height), other(subject_of(two), width / 2, height / 2);
  const Image first = painter.paint(one.positions, camera, {}),
              second = other.paint(two.positions, camera, {});
  CHECK(second.width == width / 2);
  CHECK(painter.paint(one.positions, camera, {}).rgb == first.rgb);
  Painter moved = std::move(painter);
  CHECK(other.paint(two.positions, camera, {}).rgb == second.rgb);
  CHECK(moved.paint(one.positions, camera, {}).rgb == first.rgb);
  CHECK_FALSE(moved.driver().empty());
}

TEST_CASE("a surface that lies in the shadow of another is darker, and does not shade itself") {
  if (!can_draw()) return;
  // A sheet of 2 m, and one of 0.6 m half a metre above its middle.
  Surface both = sheet(30, 30, [](double u, double v) { return Vec3(2 * u - 1, 0.0, 1 - 2 * v); });
  const Surface above =
      sheet(10, 10, [](double u, double v) { return Vec3(0.6 * u - 0.3, 0.5, 0.3 - 0.6 * v); });
  Surface lower = both;
  const Index offset = Index(both.corners());
  both.positions.insert(both.positions.end(), above.positions.begin(), above.positions.end());
  for (const Triangle& t : above.triangles)
    both.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  const Camera camera{.azimuth = 2.0, .elevation = 0.8, .distance = 4.0};
  const auto paint = [&](const Surface& surface, bool shadow) {
    Look look = surface_alone;
    look.shadow = shadow;
    return Painter(subject_of(surface), width, height).paint(surface.positions, camera, look);
  };
  // Alone, a flat sheet looks the same with shadows and without: not one stripe or spot.
  CHECK(count(difference(paint(lower, true), paint(lower, false), 1)) == 0);
  const Mask shaded = difference(paint(both, true), paint(both, false), 8);
  CHECK(count(shaded) > 500);
}
