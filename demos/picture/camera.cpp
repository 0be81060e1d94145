#include "picture/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace hooke::picture {
namespace {

/// The directions that azimuth is counted from: the camera's own where both angles are zero.
struct Compass {
  explicit Compass(const Vec3& up) {
    const auto turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitY(), up);
    side = turn * Vec3::UnitX();
    front = turn * Vec3::UnitZ();
  }
  Vec3 side, front;
};

/// Half the height of the picture at a distance of 1 m [m].
double slope(const Camera& camera) {
  return std::tan(0.5 * camera.field_of_view);
}

/// The smallest view that holds some points. In the plane of `right` and `forward`, a point is seen where
/// |r - r_eye| <= k (f - f_eye): so the eye must be behind two lines through the outermost points, and the
/// same holds for `over`.
class Fit {
 public:
  Fit(const Camera& camera, double slope_right, double slope_over)
      : right_(camera.right()),
        over_(camera.over()),
        forward_(camera.forward()),
        slopes_{slope_right, slope_over} {}

  void take(const Vec3& point) {
    const double along = point.dot(forward_);
    const double across[2] = {point.dot(right_), point.dot(over_)};
    for (int k = 0; k < 2; ++k) {
      upper_[k] = std::max(upper_[k], across[k] - slopes_[k] * along);
      lower_[k] = std::max(lower_[k], -across[k] - slopes_[k] * along);
      least_[k] = std::min(least_[k], across[k]);
      most_[k] = std::max(most_[k], across[k]);
    }
    near_ = std::min(near_, along);
    far_ = std::max(far_, along);
  }

  bool empty() const { return near_ > far_; }

  /// `camera` moved to where all points are seen. What lies in one point is seen from where the camera was
  /// told to be; what lies along one ray, from a tenth of its length before it.
  Camera view(Camera camera) const {
    const double size = std::max({far_ - near_, most_[0] - least_[0], most_[1] - least_[1]});
    const double middle = 0.5 * (near_ + far_);
    double eye = near_ - 0.1 * (far_ - near_);
    for (int k = 0; k < 2; ++k) eye = std::min(eye, -(upper_[k] + lower_[k]) / (2.0 * slopes_[k]));
    const bool one_point =
        size <= 1e-6 * std::max({1e-6, std::abs(most_[0]), std::abs(most_[1]), std::abs(middle)});
    camera.distance = one_point ? camera.distance : middle - eye;
    camera.target =
        0.5 * (upper_[0] - lower_[0]) * right_ + 0.5 * (upper_[1] - lower_[1]) * over_ + middle * forward_;
    return camera;
  }

 private:
  static constexpr double most = std::numeric_limits<double>::infinity();

  Vec3 right_, over_, forward_;
  double slopes_[2];
  double upper_[2] = {-most, -most}, lower_[2] = {-most, -most};
  double least_[2] = {most, most}, most_[2] = {-most, -most};
  double near_ = most, far_ = -most;
};

}  // namespace

Vec3 Camera::forward() const {
  const Compass compass(up);
  return -(std::cos(elevation) * (std::sin(azimuth) * compass.side + std::cos(azimuth) * compass.front) +
           std::sin(elevation) * up);
}

Vec3 Camera::right() const {
  const Compass compass(up);
  return std::cos(azimuth) * compass.side - std::sin(azimuth) * compass.front;
}

Vec3 Camera::over() const {
  return right().cross(forward());
}

Vec3 Camera::eye() const {
  return target - distance * forward();
}

Eigen::Matrix4f Camera::view() const {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.block<1, 3>(0, 0) = right().transpose();
  matrix.block<1, 3>(1, 0) = over().transpose();
  matrix.block<1, 3>(2, 0) = -forward().transpose();
  matrix.block<3, 1>(0, 3) = -matrix.block<3, 3>(0, 0) * eye();
  return matrix.cast<float>();
}

Eigen::Matrix4f Camera::projection(double aspect, double near, double far) const {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  matrix(0, 0) = 1.0 / (slope(*this) * aspect);
  matrix(1, 1) = 1.0 / slope(*this);
  matrix(2, 2) = -(far + near) / (far - near);
  matrix(2, 3) = -2.0 * far * near / (far - near);
  matrix(3, 2) = -1.0;
  return matrix.cast<float>();
}

Vec3 Camera::project(const Vec3& point, double aspect) const {
  const Vec3 from_eye = point - eye();
  const double depth = from_eye.dot(forward());
  const double height = slope(*this) * depth;
  return {from_eye.dot(right()) / (height * aspect), from_eye.dot(over()) / height, depth};
}

Vec3 Camera::ray(double x, double y, double aspect) const {
  return (forward() + slope(*this) * (x * aspect * right() + y * over())).normalized();
}

Camera fitted(Camera camera, std::span<const float> points, double aspect, double margin) {
  const double height = slope(camera) * (1.0 - 2.0 * margin);
  Fit fit(camera, height * aspect, height);
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    const Vec3 point(points[i], points[i + 1], points[i + 2]);
    if (point.allFinite()) fit.take(point);
  }
  return fit.empty() ? camera : fit.view(camera);
}

}  // namespace hooke::picture
