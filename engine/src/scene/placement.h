#pragma once

#include <Eigen/Geometry>

#include <hooke/builders.h>

#include "scene/element_checks.h"

namespace hooke {

void check_placement(const ElementChecks& checks, const Placement& placement);

/// A placement that passed its checks, as a map of points [m].
Eigen::Affine3d to_transform(const Placement& placement);

}  // namespace hooke
