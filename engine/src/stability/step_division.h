#pragma once

#include <cstdint>
#include <vector>

#include <hooke/simulation.h>

#include "stability/scene_bounds.h"

namespace hooke {

/// The longest stable step is that of forces whose derivative stays as it is. In a crumpled cloth it turns
/// with the springs, and steps at the very limit then heat it, slowly: see docs/stability.md.
inline constexpr double division_margin = 0.9;

/// In how many equal substeps, each at most division_margin of the longest stable one, `longest` [s], a step
/// [s] is taken. May be infinite, and then no step is short enough.
double needed_substeps(double step, double longest);

/// Whether the method lets an undamped oscillation stay bounded at any step at all.
bool bears_oscillations(const Method& method);

/// The bounds of a scene, and the longest stable step [s] of the settings' method.
struct StepBounds {
  SceneBounds scene;
  double longest_step = 0.0;
};

/// How many equal substeps each step is taken in, by the settings' choice. One for a method that bears no
/// step at all: shorter ones would not help it. The scene and the settings have no faults.
std::uint64_t substeps_of(const StepBounds& bounds, const Settings& settings);

/// What the settings say of trouble; where they say nothing, what is usual.
OnTrouble on_trouble(const Settings& settings);

/// Whether steps may come to be halved.
bool may_halve(const Settings& settings);

/// Adds a fault where the settings refuse a step that is too long, or where it would need too many substeps.
/// The scene has no faults, and the settings no others.
void check_stability(std::vector<Fault>& faults, const StepBounds& bounds, const Settings& settings);

/// Faults of settings and scene together, and the bounds that some of them rest on, which are not found where
/// there are other faults.
struct CheckedScene {
  std::vector<Fault> faults;
  StepBounds bounds;
};

CheckedScene check(const Scene& scene, const Settings& settings);

}  // namespace hooke
