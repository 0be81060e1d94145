#pragma once

#include <vector>

#include <hooke/scene.h>

namespace hooke::bench {

/// Where velocity Verlet with `step` [s] in double has the particles [m] of a network of springs after
/// `steps` steps, by one serial loop. Only springs and pins are looked at.
std::vector<Vec3> velocity_verlet(const Scene& network, double step, int steps);

}  // namespace hooke::bench
