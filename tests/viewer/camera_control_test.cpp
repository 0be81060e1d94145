#include "viewer/camera_control.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "viewer/picking.h"

namespace hooke::viewer {
namespace {

constexpr Viewport viewport{800.0, 600.0};
const std::vector<float> cube{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};

CameraControl fitted_control() {
  CameraControl control(Vec3::UnitY());
  control.fit(cube, viewport);
  control.arrive();
  return control;
}

Eigen::Vector2d place_of(const CameraControl& control, const Vec3& point) {
  const Vec3 seen = control.camera().project(point, viewport.aspect());
  return viewport.pixel(seen.x(), seen.y());
}

void check_all_seen(const CameraControl& control, const std::vector<float>& points) {
  for (std::size_t i = 0; i < points.size(); i += 3) {
    const Eigen::Vector2d at = place_of(control, {points[i], points[i + 1], points[i + 2]});
    CHECK(at.x() > 0.0);
    CHECK(at.x() < viewport.width);
    CHECK(at.y() > 0.0);
    CHECK(at.y() < viewport.height);
  }
}

}  // namespace

TEST_CASE("fit shows all points, and the camera is where it shows them at once when asked") {
  check_all_seen(fitted_control(), cube);
}

TEST_CASE("the camera glides to its goal and then rests") {
  CameraControl control = fitted_control();
  control.orbit({100, 50}, viewport);
  CHECK(control.moves());
  const double azimuth = control.camera().azimuth;
  control.advance(0.016);
  const double after_a_frame = control.camera().azimuth - azimuth;
  control.advance(1.0);
  const double in_the_end = control.camera().azimuth - azimuth;
  CHECK(after_a_frame / in_the_end > 0.2);  // no lag
  CHECK(after_a_frame / in_the_end < 0.8);  // no jump
  CHECK(in_the_end == doctest::Approx(-100.0 * std::numbers::pi / 600.0));
  CHECK_FALSE(control.moves());
}

TEST_CASE("the camera never goes over the top") {
  CameraControl control = fitted_control();
  for (const double up : {1.0, -1.0}) {
    control.orbit({0, up * 1e5}, viewport);
    control.arrive();
    CHECK(std::abs(control.camera().elevation) < 0.5 * std::numbers::pi);
    CHECK(std::abs(control.camera().right().dot(Vec3::UnitY())) < 1e-9);
  }
}

TEST_CASE("panning keeps what lies at the target's depth under the mouse") {
  CameraControl control = fitted_control();
  const Vec3 point = control.camera().target;
  const Eigen::Vector2d before = place_of(control, point), moved(37, -21);
  control.pan(moved, viewport);
  control.arrive();
  CHECK((place_of(control, point) - before - moved).norm() < 1e-6);
}

TEST_CASE("zooming goes nearer and keeps what is under the mouse there") {
  CameraControl control = fitted_control();
  const Eigen::Vector2d pixel(600, 150);
  const double distance = control.camera().distance;
  const Vec3 point = point_under(control.camera(), viewport, pixel, distance);
  control.zoom(3.0, pixel, viewport);
  control.arrive();
  CHECK(control.camera().distance == doctest::Approx(distance * std::pow(0.88, 3.0)));
  CHECK((place_of(control, point) - pixel).norm() < 1e-6);
}

TEST_CASE("it follows what moves out of sight, until the user moves it, and again when asked to fit") {
  const std::vector<float> far_away{0, -9, 0, 1, -9, 0};
  CameraControl control = fitted_control();
  control.follow(far_away, viewport);
  control.arrive();
  check_all_seen(control, far_away);
  check_all_seen(control, cube);
  control = fitted_control();
  control.pan({1, 0}, viewport);
  control.arrive();
  const Vec3 target = control.camera().target;
  control.follow(far_away, viewport);
  control.arrive();
  CHECK(control.camera().target == target);
  control.fit(far_away, viewport);
  control.arrive();
  check_all_seen(control, far_away);
}

TEST_CASE("positions that are not finite do not move the camera") {
  CameraControl control = fitted_control();
  const picture::Camera before = control.camera();
  control.follow(std::vector<float>{NAN, 0, 0, INFINITY, 0, 0}, viewport);
  control.advance(1.0);
  CHECK(control.camera().target == before.target);
}

}  // namespace hooke::viewer
