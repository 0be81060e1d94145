#pragma once

#include <string>
#include <vector>

#include <hooke/keyframe.h>

#include "scene/element_checks.h"
#include "scene/number_text.h"

namespace hooke {

/// Faults of the path of a frame.
inline void check_rigid_path(const std::vector<RigidKeyframe>& path, const ElementChecks& checks) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::string name = "path[" + std::to_string(i) + "]";
    checks.finite(name + ".time", path[i].time, "s");
    checks.finite(name + ".displacement", path[i].displacement, "m");
    checks.finite(name + ".degrees", path[i].degrees, "deg");
    if (i > 0 && !(path[i].time > path[i - 1].time))
      checks.add(name + ".time is " + to_text(path[i].time) + " s, not later than the one before",
                 "give keyframes in the order of their times");
  }
}

}  // namespace hooke
