#pragma once

#include <span>

#include <hooke/scene.h>

namespace hooke {

/// One moment of a simulation, in the user's numbering. Always in double: it holds every float exactly, so
/// one set of writers serves both precisions, and each writer narrows to what its file stores.
struct Frame {
  double time = 0.0;                 ///< [s]
  std::span<const Vec3> positions;   ///< [m]
  std::span<const Vec3> velocities;  ///< [m/s]
  const Scene* torn = nullptr;       ///< the scene as it has torn; null where it has not
};

}  // namespace hooke
