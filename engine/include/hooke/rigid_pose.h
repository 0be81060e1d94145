#pragma once

#include <Eigen/Geometry>

#include <hooke/vec3.h>

namespace hooke {

/// A rigid transform: something is turned by `rotation`, and displaced. Of a frame it turns about the frame's
/// origin at the start of the scene; of a teleport about the origin of the world.
struct RigidPose {
  Vec3 displacement = Vec3::Zero();                              ///< [m]
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< of unit length
};

/// What a frame has to carry: a force [N], and a torque about the frame's origin [N m].
struct FrameLoad {
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();
};

}  // namespace hooke
