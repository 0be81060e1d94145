#pragma once

#include <vector>

#include <hooke/scene.h>

namespace hooke::bench {

/// How far the particles have fallen since the start [m], on average, along the scene's gravity.
double mean_fall(const Scene& scene, const std::vector<Vec3>& positions);

/// Throws std::runtime_error unless pinned particles are where they were and the others have fallen, but not
/// further than freely. For programs with another method than ours, whose positions cannot be compared.
/// `time` [s] since the start, `step` [s].
void require_falling(const Scene& scene, const std::vector<Vec3>& positions, double time, double step);

}  // namespace hooke::bench
