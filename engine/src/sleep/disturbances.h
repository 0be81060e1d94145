#pragma once

#include <hooke/index.h>
#include <hooke/vec3.h>

namespace hooke {

/// Takes note of who cannot be at rest in a step.
class Disturbances {
 public:
  virtual ~Disturbances() = default;

  /// Everything.
  virtual void all() = 0;

  /// A particle, of the engine's order.
  virtual void particle(Index particle) = 0;

  /// What is in a box with sides along the axes [m].
  virtual void box(const Vec3& low, const Vec3& high) = 0;
};

}  // namespace hooke
