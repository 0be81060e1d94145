#pragma once

#include <hooke/methods.h>
#include <hooke/scene.h>

/// How fast a scene can move, and so how long a step it allows. All are upper bounds, found from the springs,
/// drag and ground planes of the scene without simulating it; a Field's stiffness is not known and not
/// counted.
///
/// They hold however springs are stretched or pressed: what pressing adds across a spring is a negative
/// stiffness, which makes it buckle and not swing.

namespace hooke {

/// No oscillation of the scene has a greater angular frequency [1/s]; 0 where nothing pulls.
double highest_frequency(const Scene& scene);

/// The largest eigenvalue of M^-1 C [1/s], with C the damping of springs, drag and ground, is not greater.
double highest_damping_rate(const Scene& scene);

/// The largest eigenvalue of M^-1 (h^2 K + 2 h C) [1] for steps of h = `step` [s] is not greater. Symplectic
/// Euler is stable where this is below 4: a mode obeys R^2 - (2 - h^2 k - h c) R + (1 - h c) = 0, whose roots
/// stay in the unit circle as long as h^2 k + 2 h c < 4 (with the usual k = w^2, c = 2 zeta w).
double stability_number(const Scene& scene, double step);

/// The longest step [s] with which the method surely lets no oscillation and no decay of the scene grow, by
/// the bounds above. Infinite where nothing pulls or brakes, and for a method that chooses its steps. 0 for a
/// method that lets undamped oscillations grow however short its step, where the scene has springs.
double largest_stable_step(const Scene& scene, const Method& method);

}  // namespace hooke
