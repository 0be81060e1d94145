#pragma once

#include <Eigen/Core>

namespace hooke {

/// A point, a velocity or a force in space, always in double precision at the edge of the library.
using Vec3 = Eigen::Vector3d;

}  // namespace hooke
