#include "collide/collider_motion.h"

#include <numbers>

namespace hooke {

ColliderMotion::ColliderMotion(const Collider& collider)
    : origin_(origin_of(collider.shape)), axis_(collider.axis.stableNormalized()), path_(collider.path) {}

Vec3 ColliderMotion::origin(double time) const {
  return origin_ + on_path(path_, time).displacement;
}

double ColliderMotion::angle(double time) const {
  return on_path(path_, time).degrees * std::numbers::pi / 180.0;
}

Eigen::Matrix3d ColliderMotion::rotation(double time) const {
  return Eigen::AngleAxisd(angle(time), axis_).toRotationMatrix();
}

template <class Real>
Pose<Real> pose_at(const ColliderMotion& motion, double time) {
  const Eigen::Matrix3d rotation = motion.rotation(time);
  const Vec3 origin = motion.origin(time);
  Pose<Real> pose;
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) pose.rotation[i][j] = Real(rotation(i, j));
    pose.origin[i] = Real(origin[i]);
  }
  return pose;
}

template Pose<float> pose_at(const ColliderMotion&, double);
template Pose<double> pose_at(const ColliderMotion&, double);

}  // namespace hooke
