#pragma once

#include "collide/contact.h"
#include "frames/rigid_motion.h"

namespace hooke {

/// In the precision of the run.
template <class Real>
Pose<Real> pose_of(const FramePlace& place) {
  Pose<Real> pose;
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) pose.rotation[i][j] = Real(place.rotation(i, j));
    pose.origin[i] = Real(place.origin[i]);
  }
  return pose;
}

}  // namespace hooke
