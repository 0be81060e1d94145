#include "picture/framing.h"

#include <doctest/doctest.h>

#include "picture/light_direction.h"

using namespace hooke;
using namespace hooke::picture;

namespace {

Vec3 last_point(const std::vector<float>& points) {
  const float* const x = points.data() + points.size() - 3;
  return {x[0], x[1], x[2]};
}

}  // namespace

TEST_CASE("a floor lies a little under a scene") {
  const std::vector<float> points = {0, 1, 0, 3, 5, 0};  // 5 m from corner to corner
  CHECK(floor_under(bounds_of(points), Vec3(0, 1, 0)) == doctest::Approx(1.0 - 0.15));
  CHECK(floor_under(bounds_of(points), Vec3(0, -1, 0)) == doctest::Approx(-5.0 - 0.15));
}

TEST_CASE("shadows lie on the floor, where the light through a point meets it") {
  const std::vector<float> points = {0, 1, 0, 1, 2, 0};
  const Subject subject{.particles = 2};
  const std::vector<float> all = with_shadows(points, subject, {.floor_height = 0.5});
  REQUIRE(all.size() == 12);
  const Vec3 shadow = last_point(all), to_light = direction_to_light(subject.up);
  CHECK(shadow.y() == doctest::Approx(0.5));
  CHECK((Vec3(1, 2, 0) - shadow).normalized().dot(to_light) == doctest::Approx(1.0));
  CHECK(to_light.norm() == doctest::Approx(1.0));
  CHECK(to_light.y() > 0.7);
}

TEST_CASE("shadows fall on the scene's own ground, but not on one far below, nor on one above") {
  const std::vector<float> points = {0, 1, 0, 1, 2, 0};
  Subject subject{.particles = 2};
  subject.grounds = {GroundPlane{.normal = Vec3(0, 2, 0), .height = 0.8}};
  CHECK(last_point(with_shadows(points, subject, {})).y() == doctest::Approx(0.8));
  subject.grounds[0].height = -30.0;
  CHECK(with_shadows(points, subject, {}).size() == 6);
  subject.grounds[0].height = 30.0;
  CHECK(with_shadows(points, subject, {}).size() == 6);
}

TEST_CASE("where no shadow is drawn none is asked for") {
  const std::vector<float> points = {0, 1, 0};
  CHECK(with_shadows(points, {.particles = 1}, {.ground = false}).size() == 3);
  CHECK(with_shadows(points, {.particles = 1}, {.shadow = false}).size() == 3);
}
