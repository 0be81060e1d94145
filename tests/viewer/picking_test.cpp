#include "viewer/picking.h"

#include <doctest/doctest.h>

namespace hooke::viewer {
namespace {

constexpr Viewport viewport{800.0, 600.0};

/// Looks along -z at the origin, from 10 m.
picture::Camera camera() {
  picture::Camera camera;
  camera.azimuth = camera.elevation = 0.0;
  camera.distance = 10.0;
  return camera;
}

Eigen::Vector2d place_of(const Vec3& point) {
  const Vec3 seen = camera().project(point, viewport.aspect());
  return viewport.pixel(seen.x(), seen.y());
}

std::optional<Index> picked(const std::vector<float>& positions, const Eigen::Vector2d& pixel) {
  return pick(positions, std::vector<bool>(positions.size() / 3), camera(), viewport, pixel, 12.0);
}

}  // namespace

TEST_CASE("the particle nearest to the mouse is picked, as the camera draws it") {
  const std::vector<float> positions{0, 0, 0, 0.5f, 0.25f, 1, -1, -1, 0};
  for (Index i = 0; i < 3; ++i) {
    const Vec3 point(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
    CHECK(picked(positions, place_of(point) + Eigen::Vector2d(3, -4)) == i);
  }
}

TEST_CASE("beyond the radius nothing is picked") {
  const std::vector<float> positions{0, 0, 0};
  CHECK(picked(positions, {400.0 + 11.9, 300.0}) == 0);
  CHECK_FALSE(picked(positions, {400.0 + 12.1, 300.0}));
}

TEST_CASE("what is in front hides what is behind, even where that is nearer to the mouse") {
  const std::vector<float> positions{0, 0, -5, 0.05f, 0, 5};
  CHECK(picked(positions, {400.0, 300.0}) == 1);
}

TEST_CASE("pinned particles and those behind the eye are not picked") {
  const std::vector<float> behind{0, 0, 20};
  CHECK_FALSE(picked(behind, {400.0, 300.0}));
  const std::vector<float> one{0, 0, 0};
  CHECK_FALSE(pick(one, {true}, camera(), viewport, {400.0, 300.0}, 12.0));
}

TEST_CASE("a point under the mouse is seen there, at its depth") {
  const Eigen::Vector2d pixel(123.0, 456.0);
  const Vec3 point = point_under(camera(), viewport, pixel, 7.0);
  CHECK((place_of(point) - pixel).norm() < 1e-9);
  CHECK(depth_of(camera(), point) == doctest::Approx(7.0));
}

}  // namespace hooke::viewer
