#include "picture/camera.h"

#include <doctest/doctest.h>

#include <limits>
#include <random>
#include <vector>

#include <hooke/vec3.h>
#include <Eigen/Geometry>

using namespace hooke;
using namespace hooke::picture;

namespace {

const std::vector<Vec3> ups = {{0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {1, 0, 0}, Vec3(1, 2, -3).normalized()};

/// Cameras that look from all around, each with another upward direction in turn.
std::vector<Camera> cameras() {
  std::vector<Camera> all;
  for (int k = 0; k < 40; ++k) {
    all.push_back({.target = Vec3(0.3 * k, -2.0, 1.0),
                   .up = ups[std::size_t(k) % ups.size()],
                   .azimuth = 0.7 * k,
                   .elevation = -1.5 + 0.075 * k,
                   .distance = 0.5 + k,
                   .field_of_view = 0.3 + 0.02 * k});
  }
  return all;
}

std::vector<float> cloud(int points, double size, const Vec3& centre = Vec3::Zero()) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-size, size);
  std::vector<float> all;
  for (int k = 0; k < points; ++k) {
    for (int axis = 0; axis < 3; ++axis) all.push_back(float(centre[axis] + place(random)));
  }
  return all;
}

/// The largest |x| and |y| at which points are seen, and the least depth.
struct Seen {
  double left = 1e9, right = -1e9, bottom = 1e9, top = -1e9, near = 1e9;
};

Seen seen(const Camera& camera, const std::vector<float>& points, double aspect) {
  Seen all;
  for (std::size_t i = 0; i < points.size(); i += 3) {
    const Vec3 place = camera.project(Vec3(points[i], points[i + 1], points[i + 2]), aspect);
    all.left = std::min(all.left, place.x());
    all.right = std::max(all.right, place.x());
    all.bottom = std::min(all.bottom, place.y());
    all.top = std::max(all.top, place.y());
    all.near = std::min(all.near, place.z());
  }
  return all;
}

bool is_sane(const Camera& camera) {
  return camera.target.allFinite() && std::isfinite(camera.distance) && camera.distance > 0.0;
}

}  // namespace

TEST_CASE("a camera's axes are perpendicular and of unit length, and it looks at its target") {
  for (const Camera& camera : cameras()) {
    Eigen::Matrix3d axes;
    axes << camera.right(), camera.over(), -camera.forward();
    CHECK((axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm() < 1e-12);
    CHECK(axes.determinant() == doctest::Approx(1.0));
    CHECK((camera.eye() + camera.distance * camera.forward() - camera.target).norm() < 1e-9);
    CHECK(camera.right().dot(camera.up) == doctest::Approx(0.0));
    CHECK(camera.over().dot(camera.up) > 0.0);
    CHECK(-camera.forward().dot(camera.up) == doctest::Approx(std::sin(camera.elevation)));
  }
}

TEST_CASE("from the front is along z where y is up, and along -y where z is up") {
  CHECK((Camera{.azimuth = 0.0, .elevation = 0.0}.forward() - Vec3(0, 0, -1)).norm() < 1e-12);
  CHECK((Camera{.azimuth = 0.0, .elevation = 0.0}.right() - Vec3(1, 0, 0)).norm() < 1e-12);
  CHECK((Camera{.up = Vec3(0, 0, 1), .azimuth = 0.0, .elevation = 0.0}.forward() - Vec3(0, 1, 0)).norm() <
        1e-12);
}

TEST_CASE("matrices see a point where project() does") {
  const double aspect = 1.7;
  for (const Camera& camera : cameras()) {
    const double near = 0.01 * camera.distance, far = 10.0 * camera.distance;
    const Eigen::Matrix4f matrix = camera.projection(aspect, near, far) * camera.view();
    const Vec3 point = camera.target + 0.1 * camera.distance * Vec3(0.6, -0.5, 0.4);
    const Eigen::Vector4f clip = matrix * point.cast<float>().homogeneous();
    const Vec3 place = camera.project(point, aspect);
    CHECK(clip.x() / clip.w() == doctest::Approx(place.x()).epsilon(1e-4));
    CHECK(clip.y() / clip.w() == doctest::Approx(place.y()).epsilon(1e-4));
    CHECK(clip.w() == doctest::Approx(place.z()).epsilon(1e-4));
    for (const double depth : {near, far}) {
      const Eigen::Vector4f end =
          matrix * (camera.eye() + depth * camera.forward()).cast<float>().eval().homogeneous();
      CHECK(end.z() / end.w() == doctest::Approx(depth == near ? -1.0 : 1.0).epsilon(2e-3));
    }
  }
}

TEST_CASE("a ray goes through the points that are seen at its place") {
  const double aspect = 1.5;
  for (const Camera& camera : cameras()) {
    for (const double x : {-1.0, 0.0, 0.4}) {
      for (const double y : {-0.7, 0.0, 1.0}) {
        const Vec3 ray = camera.ray(x, y, aspect);
        CHECK(ray.norm() == doctest::Approx(1.0));
        const Vec3 place = camera.project(camera.eye() + 3.0 * ray, aspect);
        CHECK(place.x() == doctest::Approx(x));
        CHECK(place.y() == doctest::Approx(y));
      }
    }
  }
}

TEST_CASE("a point behind the eye has a negative depth") {
  const Camera camera;
  CHECK(camera.project(camera.eye() - camera.forward(), 1.0).z() == doctest::Approx(-1.0));
}

TEST_CASE("a fitted camera shows all points and no more than the margin around them") {
  const std::vector<float> points = cloud(200, 0.7, Vec3(3, -5, 2));
  for (const double aspect : {0.5, 1.0, 16.0 / 9.0}) {
    for (const double margin : {0.0, 0.06, 0.2}) {
      for (const Camera& before : cameras()) {
        const Camera camera = fitted(before, points, aspect, margin);
        const Seen all = seen(camera, points, aspect);
        const double limit = 1.0 - 2.0 * margin;
        CHECK(all.near > 0.0);
        CHECK(std::max({-all.left, all.right, -all.bottom, all.top}) == doctest::Approx(limit).epsilon(1e-4));
        // As much room on both sides, or it would not be in the middle: exactly so across the tight
        // direction.
        const bool wide = all.right - all.left > all.top - all.bottom;
        CHECK((wide ? all.left + all.right : all.bottom + all.top) == doctest::Approx(0.0).epsilon(1e-4));
        CHECK((camera.forward() - before.forward()).norm() < 1e-12);
      }
    }
  }
}

TEST_CASE("a camera for one point, or points that are all the same, keeps its distance") {
  for (const int count : {1, 5}) {
    std::vector<float> points;
    for (int k = 0; k < count; ++k) points.insert(points.end(), {2.0f, 3.0f, 4.0f});
    const Camera camera = fitted({.distance = 2.5}, points, 1.5);
    CHECK(camera.distance == 2.5);
    CHECK((camera.target - Vec3(2, 3, 4)).norm() < 1e-12);
  }
}

TEST_CASE("a camera for no points, or none that is finite, stays where it is") {
  const float bad = std::numeric_limits<float>::quiet_NaN();
  for (const std::vector<float>& points : {std::vector<float>{}, std::vector<float>{bad, 0.0f, 1.0f}}) {
    const Camera camera = fitted({.target = Vec3(1, 2, 3), .distance = 4.0}, points, 1.5);
    CHECK(camera.target == Vec3(1, 2, 3));
    CHECK(camera.distance == 4.0);
  }
}

TEST_CASE("points that are not finite do not count") {
  std::vector<float> points = cloud(50, 1.0);
  const Camera without = fitted({}, points, 1.5);
  points.insert(points.end(), {std::numeric_limits<float>::infinity(), 0.0f, 0.0f});
  points.insert(points.end(), {0.0f, std::numeric_limits<float>::quiet_NaN(), 0.0f});
  const Camera with = fitted({}, points, 1.5);
  CHECK(with.target == without.target);
  CHECK(with.distance == without.distance);
}

TEST_CASE("a camera for a line sees all of it, from the side and along it") {
  for (const Camera& before : cameras()) {
    for (const Vec3& direction : {before.right(), before.over(), before.forward()}) {
      std::vector<float> points;
      for (int k = 0; k < 5; ++k) {
        for (int axis = 0; axis < 3; ++axis) points.push_back(float(0.25 * k * direction[axis]));
      }
      const Camera camera = fitted(before, points, 1.5);
      CHECK(is_sane(camera));
      const Seen all = seen(camera, points, 1.5);
      CHECK(all.near > 0.05);
      CHECK(std::max({-all.left, all.right, -all.bottom, all.top}) < 0.89);
    }
  }
}

TEST_CASE("very small and very large scenes, and such as lie far away, are fitted too") {
  for (const double size : {1e-6, 1e-3, 1e6}) {
    const Seen all = seen(fitted({}, cloud(50, size), 1.5), cloud(50, size), 1.5);
    CHECK(std::max({-all.left, all.right, -all.bottom, all.top}) == doctest::Approx(0.88).epsilon(1e-3));
  }
  const std::vector<float> far = cloud(50, 1.0, Vec3(1e4, 1e4, -1e4));
  const Seen all = seen(fitted({}, far, 1.5), far, 1.5);
  CHECK(std::max({-all.left, all.right, -all.bottom, all.top}) == doctest::Approx(0.88).epsilon(1e-3));
}
