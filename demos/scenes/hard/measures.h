#pragma once

#include <vector>

#include <hooke/scene.h>

/// What cases measure of a state: positions are in the user's numbering.

namespace hooke::hard {

/// |l / l0 - 1| of each spring with a rest length [1].
std::vector<double> strains(const Scene& scene, const std::vector<Vec3>& positions);

/// The share of the springs with a rest length whose strain is at most `limit` [1].
double share_within(const Scene& scene, const std::vector<Vec3>& positions, double limit);

/// The largest force [N] of springs and gravity on a particle that is not pinned, at rest.
double largest_force(const Scene& scene, const std::vector<Vec3>& positions);

/// Of all particles that are not pinned [N].
double weight(const Scene& scene);

/// The largest distance between places of the same number [m].
double largest_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

/// Of all particles that are not pinned, from velocities [J].
double kinetic_energy(const Scene& scene, const std::vector<Vec3>& velocities);

}  // namespace hooke::hard
