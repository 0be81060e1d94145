#pragma once

#include <limits>
#include <string>
#include <vector>

#include <hooke/keyframe.h>

#include "scene/element_checks.h"

namespace hooke {

/// Faults of the path of a frame.
inline void check_rigid_path(const std::vector<RigidKeyframe>& path, const ElementChecks& checks) {
  double latest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::string name = "path[" + std::to_string(i) + "]";
    checks.later_time(name + ".time", path[i].time, latest);
    checks.finite(name + ".displacement", path[i].displacement, "m");
    checks.finite(name + ".degrees", path[i].degrees, "deg");
  }
}

}  // namespace hooke
