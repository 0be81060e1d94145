#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include <hooke/rigid_pose.h>

namespace hooke {

/// Throws std::invalid_argument where a pose, given to the function of this name, is none.
inline void require_pose(const std::string& function, const RigidPose& pose) {
  constexpr double tolerance = 1e-6;
  if (!pose.displacement.allFinite() || !pose.rotation.coeffs().allFinite())
    throw std::invalid_argument(function + ": the pose is not finite; give finite values");
  if (std::abs(pose.rotation.norm() - 1.0) > tolerance)
    throw std::invalid_argument(function + ": the rotation has a length of " +
                                std::to_string(pose.rotation.norm()) + "; give a quaternion of length 1");
}

}  // namespace hooke
