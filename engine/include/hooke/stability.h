#pragma once

#include <hooke/scene.h>

/// How fast a scene can move, and so how long a step it allows. All are upper bounds, found from the springs,
/// drag and ground planes of the scene without simulating it; a Field's stiffness is not known and not
/// counted.
///
/// They hold for springs that are not pressed to less than half of their rest length: below that a spring's
/// sideways stiffness exceeds k.

namespace hooke {

/// No oscillation of the scene has a greater angular frequency [1/s]; 0 where nothing pulls.
double highest_frequency(const Scene& scene);

/// The largest eigenvalue of M^-1 C [1/s], with C the damping of springs, drag and ground, is not greater.
double highest_damping_rate(const Scene& scene);

/// The largest eigenvalue of M^-1 (h^2 K + 2 h C) [1] for steps of h = `step` [s] is not greater. Symplectic
/// Euler is stable where this is below 4: a mode obeys R^2 - (2 - h^2 k - h c) R + (1 - h c) = 0, whose roots
/// stay in the unit circle as long as h^2 k + 2 h c < 4 (with the usual k = w^2, c = 2 zeta w).
double stability_number(const Scene& scene, double step);

}  // namespace hooke
