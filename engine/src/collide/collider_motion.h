#pragma once

#include <Eigen/Geometry>

#include <hooke/effects.h>

#include "collide/contact.h"

namespace hooke {

/// How a collider moves: its pose at any time, by the keyframes of its path.
class ColliderMotion {
 public:
  explicit ColliderMotion(const Collider& collider);

  /// Whether it is in one place at all times.
  bool still() const { return path_.size() < 2; }

  Vec3 origin(double time) const;  ///< of its frame, in the world [m]
  Eigen::Matrix3d rotation(double time) const;
  double angle(double time) const;  ///< [rad]
  const Vec3& axis() const { return axis_; }

  std::size_t bytes() const { return path_.capacity() * sizeof(RigidKeyframe); }

 private:
  Vec3 origin_, axis_;
  std::vector<RigidKeyframe> path_;
};

/// In the precision of the run.
template <class Real>
Pose<Real> pose_at(const ColliderMotion& motion, double time);

}  // namespace hooke
