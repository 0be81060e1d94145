#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <hooke/methods.h>
#include <hooke/scene.h>

/// How fast a scene can move, and so how long a step it allows. The functions give upper bounds, found from
/// the springs and effects of the scene without simulating it; a Field's stiffness is not known and not
/// counted. Of hinges the bound is that of the shape at the start, with half as much again for what folds.
///
/// They hold however springs are stretched or pressed: what pressing adds across a spring is a negative
/// stiffness, which makes it buckle and not swing. Where springs turn fast, as in a crumpled cloth, steps
/// close to a limit can still heat the motion slowly: steps that are divided (UnstableStep::divide) are at
/// most 0.9 of the longest.

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
/// the bounds above. Infinite where nothing pulls or brakes, and for a method that chooses its steps or
/// solves equations. 0 for a method that lets undamped oscillations grow however short its step, where the
/// scene has springs.
double largest_stable_step(const Scene& scene, const Method& method);

/// A method for a scene, and why.
struct Recommendation {
  Method method;
  std::string reason;  ///< a sentence
};

/// The method to begin with where a scene is to be simulated in steps of `step` [s] and to look right: the
/// explicit one while its substeps, of one evaluation of forces each, cost less than an implicit step with
/// its iterations, which is longer where there is contact. It rests on the bounds above, not on the state.
/// The scene and the step have no faults.
Recommendation recommended_method(const Scene& scene, double step);

/// What a method makes of a scene's bounds.
struct MethodStability {
  std::string_view method;    ///< its name
  double longest_step = 0.0;  ///< see largest_stable_step() [s]
  /// Equal parts, of at most 0.9 of the longest step, in which it takes one of the settings' length [1];
  /// infinite where it bears no step at all.
  double substeps = 1.0;
};

/// How stable a simulation is: what is guaranteed of its scene, and what is found in its state of now. See
/// Simulation::stability().
struct Stability {
  static constexpr Index none = ~Index{0};

  double frequency_bound = 0.0;  ///< highest_frequency() [1/s]: no state has a greater one
  /// The highest angular frequency in the state of now [1/s], of the derivative of spring and ground forces,
  /// by Lanczos' method. As any result of that method it is from below.
  double frequency = 0.0;
  /// The true one is not greater [1/s], but for a chance of 1e-6 (Kuczynski and Wozniakowski 1992); nor is
  /// the bound. Typically 1 or 2 % more than `frequency`.
  double frequency_at_most = 0.0;
  double damping_bound = 0.0;  ///< highest_damping_rate() [1/s]
  /// The largest c / (2 sqrt(k m)) of a spring alone [1], with 1 / m the sum of both ends' 1 / mass: 1 where
  /// a spring's ends stop swinging about each other. 0 without dampers, infinite for a damper without
  /// stiffness.
  double damping_ratio = 0.0;
  Index worst_damper = none;             ///< the spring with that damping ratio, in the user's numbering
  double step = 0.0;                     ///< of the settings [s]
  std::string_view method;               ///< of the settings
  std::vector<MethodStability> methods;  ///< in the order of all_methods

  /// A few sentences that say what this means for the step.
  std::string text() const;
};

}  // namespace hooke
