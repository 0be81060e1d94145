// The ground, its grid, and the shadows on it.

#include "drawing.h"
#include "picture/ground_layer.h"
#include "picture/light_direction.h"

using namespace hooke;
using namespace hooke::picture;
using namespace hooke::test;

namespace {

/// A level square of 0.6 m, 0.5 m above the floor, seen from above.
struct Hovering {
  Surface surface = sheet(4, 4, [](double u, double v) { return Vec3(0.6 * u - 0.3, 0.5, 0.3 - 0.6 * v); });
  Camera camera{.elevation = 0.7, .distance = 5.0};
  Look look{.springs = false, .particles = false, .pins = false, .floor_height = 0.0};

  Image paint(bool shadow, const Subject& subject) const {
    Look drawn = look;
    drawn.shadow = shadow;
    return Painter(subject, width, height).paint(surface.positions, camera, drawn);
  }
  Image paint(bool shadow) const { return paint(shadow, subject_of(surface)); }

  /// Where the light through this place of the square meets the floor.
  Vec3 shadow_of(double x, double z) const {
    const Vec3 to_light = direction_to_light(Vec3(0, 1, 0));
    return Vec3(x, 0.5, z) - 0.5 / to_light.y() * to_light;
  }
};

}  // namespace

TEST_CASE("a shadow darkens the ground where the light is hidden, and nowhere else") {
  if (!can_draw()) return;
  const Hovering scene;
  const Image lit = scene.paint(false), shaded = scene.paint(true);
  const auto darker = [&](const Vec3& place) {
    return brightness(pixel_at(lit, scene.camera, place)) - brightness(pixel_at(shaded, scene.camera, place));
  };
  CHECK(darker(scene.shadow_of(0.2, 0.1)) > 60);
  for (const double x : {-1.0, 1.0}) {
    for (const double z : {-0.8, 0.8}) CHECK(darker(Vec3(x, 0, z)) == 0);
  }
  // All that is darker lies in the exact shadow, or near it: the square's outline, seen on the floor.
  Surface exact = scene.surface;
  for (std::size_t k = 0; k < exact.corners(); ++k) {
    const Eigen::Vector3f x = scene.shadow_of(exact.corner(k).x(), exact.corner(k).z()).cast<float>();
    std::copy_n(x.data(), 3, exact.positions.begin() + std::ptrdiff_t(3 * k));
  }
  const Mask expected = covered(exact, scene.camera), cloth = covered(scene.surface, scene.camera);
  double area = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) area += expected[i] && !cloth[i];
  Mask half = difference(lit, shaded, 25);
  CHECK(area > 500);
  CHECK(count(half) == doctest::Approx(area).epsilon(0.12));
}

TEST_CASE("the edge of a shadow is soft") {
  if (!can_draw()) return;
  const Hovering scene;
  const Image lit = scene.paint(false), shaded = scene.paint(true);
  const double few = count(difference(lit, shaded, 2)), many = count(difference(lit, shaded, 40));
  CHECK(few > 1.1 * many);
}

TEST_CASE("shadows do not jump from one frame to the next, though the map follows the scene") {
  if (!can_draw()) return;
  Hovering scene;
  scene.camera = {.target = scene.shadow_of(0.3, -0.3), .azimuth = 2.6, .elevation = 0.9, .distance = 1.6};
  const std::size_t corners = scene.surface.corners();
  Subject subject = subject_of(scene.surface);
  subject.particles = corners + 1;
  Painter painter(subject, width, height);
  std::vector<float> positions = scene.surface.positions;
  positions.insert(positions.end(), {0, 0.5f, 0});
  Image before = painter.paint(positions, scene.camera, scene.look);
  CHECK(count(difference(before, scene.paint(false), 25)) > 500);
  // A particle that is not drawn goes away, and makes the scene twice as large by small steps.
  int largest = 0;
  for (int k = 1; k <= 40; ++k) {
    positions[3 * corners] = 0.03f * float(k);
    const Image now = painter.paint(positions, scene.camera, scene.look);
    while (count(difference(now, before, largest)) > 0) ++largest;
    before = now;
  }
  CHECK(largest <= 8);
}

TEST_CASE("a ground plane is drawn where it is, and tilted as it is") {
  if (!can_draw()) return;
  const Hovering scene;
  Subject subject = subject_of(scene.surface);
  subject.grounds = {GroundPlane{.normal = Vec3(0, 3, 0), .height = 0.0}};
  CHECK(scene.paint(true, subject).rgb == scene.paint(true).rgb);  // as a floor at the same height
  subject.grounds[0].normal = Vec3(0.5, 1, 0);
  CHECK(scene.paint(true, subject).rgb != scene.paint(true).rgb);
  subject.grounds[0].normal = Vec3(0, -1, 0);  // seen from below: it must not hide the scene
  Look without = scene.look;
  without.ground = without.shadow = false;
  CHECK(scene.paint(false, subject).rgb ==
        Painter(subject, width, height).paint(scene.surface.positions, scene.camera, without).rgb);
}

TEST_CASE("the ground is level with what lies on it: a ball that lies half in it is cut in half") {
  if (!can_draw()) return;
  const Surface round = ball(48, 24);
  Subject subject = subject_of(round);
  Look look{.springs = false, .particles = false, .pins = false, .shadow = false, .floor_height = 0.0};
  const Camera camera{.azimuth = 0.0, .elevation = 0.05, .distance = 6.0};
  Painter painter(subject, width, height);
  const Image cut = painter.paint(round.positions, camera, look);
  look.surface = false;
  const double seen = count(difference(cut, painter.paint(round.positions, camera, look)));
  const double whole = count(covered(round, camera));
  CHECK(seen == doctest::Approx(0.5 * whole).epsilon(0.1));
}

TEST_CASE("the lines of the grid are a round number of metres apart, some seven in a picture's height") {
  for (double distance = 1e-4; distance < 1e5; distance *= 1.7) {
    const Camera camera{.distance = distance};
    const double spacing = grid_spacing(camera), lines = height_seen(camera) / spacing;
    CHECK(lines <= 7.1);
    CHECK(lines >= 7.0 / 2.5 - 0.1);
    const double digit = spacing / std::pow(10.0, std::floor(std::log10(spacing * 1.0001)));
    CHECK((std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 || std::abs(digit - 5) < 1e-6));
  }
}

TEST_CASE("lines of the grid are darker than the ground between them") {
  if (!can_draw()) return;
  const Hovering scene;
  const double spacing = grid_spacing(scene.camera);
  const Image image = scene.paint(false);
  for (int k = 1; k <= 2; ++k) {
    const auto at = [&](double x) {
      return brightness(pixel_at(image, scene.camera, Vec3(x, 0, 0.5 * spacing)));
    };
    CHECK(at(k * spacing) < at((k + 0.5) * spacing) - 10);
    CHECK(std::abs(at((k + 0.5) * spacing) - at((k + 0.4) * spacing)) <= 3);
  }
}
