#include "scene/placement.h"

#include <numbers>

namespace hooke {

void check_placement(const ElementChecks& checks, const Placement& placement) {
  checks.finite("placement.translation", placement.translation, "m");
  checks.direction("placement.rotation_axis", placement.rotation_axis);
  checks.finite("placement.rotation_degrees", placement.rotation_degrees, "degrees");
  checks.positive("placement.scale", placement.scale, "");
}

Eigen::Affine3d to_transform(const Placement& placement) {
  const double angle = placement.rotation_degrees * std::numbers::pi / 180.0;
  // stableNormalized: an axis of any length must do, also one whose square overflows.
  const Eigen::AngleAxisd rotation(angle, placement.rotation_axis.stableNormalized());
  return Eigen::Translation3d(placement.translation) * rotation * Eigen::Scaling(placement.scale);
}

}  // namespace hooke
