#pragma once

#include <vector>

#include <hooke/scene.h>

namespace hooke::bench {

/// A scene that is nothing but springs, and moves: no gravity, no drag, at rest length but with waves of
/// velocity in it, so that a few steps strain the springs by some per cent. What another program must know to
/// repeat it is particles, springs and pins.
Scene moving_network(const Scene& scene, double step);

/// Where velocity Verlet with `step` [s] in double has the particles after `steps` steps, by one serial loop.
std::vector<Vec3> velocity_verlet(const Scene& network, double step, int steps);

/// The network with its velocities half a kick earlier: symplectic Euler started there has the positions of
/// velocity Verlet, as x1 = x0 + h (v0 + h/2 a0) in both.
Scene half_kick_earlier(const Scene& network, double step);

}  // namespace hooke::bench
