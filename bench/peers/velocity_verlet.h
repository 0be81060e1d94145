#pragma once

#include <vector>

#include <hooke/scene.h>

namespace hooke::bench {

/// The acceleration [m/s^2] of every particle by its springs; zero where it is pinned.
std::vector<Vec3> accelerations(const Scene& network, const std::vector<Vec3>& positions);

/// Where velocity Verlet with `step` [s] in double has the particles [m] of a network of springs after
/// `steps` steps, by one serial loop. Only springs and pins are looked at.
std::vector<Vec3> velocity_verlet(const Scene& network, double step, int steps);

}  // namespace hooke::bench
