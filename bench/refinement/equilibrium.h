#pragma once

#include <vector>

#include <hooke/hooke.h>

namespace hooke::bench {

/// Where the particles of a scene come to rest [m], in the user's numbering: by steps of backward Euler that
/// are so long [s] that inertia hardly counts, until a step moves nothing by more than `still` [m]. Throws
/// std::runtime_error where 2,000 steps do not suffice.
std::vector<Vec3> equilibrium(const Scene& scene, double step, double still);

/// Likewise from places [m] near it, at rest, and from a time [s] at which pins have come to their ends.
std::vector<Vec3> equilibrium_from(const std::vector<Vec3>& start, double time, const Scene& scene,
                                   double step, double still);

std::vector<Vec3> positions_of(const Simulation<double>& simulation);

}  // namespace hooke::bench
