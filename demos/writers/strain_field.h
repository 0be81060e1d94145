#pragma once

#include <span>
#include <vector>

#include <hooke/scene.h>

namespace hooke {

/// How far a scene's springs are stretched, seen at each particle.
class StrainField {
 public:
  /// `scene` must outlive the field.
  explicit StrainField(const Scene& scene);

  /// For each particle the strain (l - l0) / l0 [1] of whichever of its springs is strained most, in tension
  /// (> 0) or compression (< 0). Springs without a rest length have no strain; a particle without others has
  /// 0. Valid until the next call.
  std::span<const double> at(std::span<const Vec3> positions);

 private:
  const Springs* springs_;
  std::vector<double> strain_;
};

}  // namespace hooke
