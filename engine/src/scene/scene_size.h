#pragma once

#include <hooke/scene.h>

namespace hooke {

/// The length [m] that errors in positions are compared with: the diagonal of the box around all particles,
/// or the longest rest length if that is longer, as in a scene that begins folded up; 1 m for a particle
/// alone.
double scene_size(const Scene& scene);

}  // namespace hooke
