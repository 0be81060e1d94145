#include <algorithm>
#include <string>
#include <variant>

#include <hooke/stability.h>

#include "collide/solid_bounds.h"
#include "scene/number_text.h"
#include "stability/scene_bounds.h"
#include "stability/step_division.h"

namespace hooke {
namespace {

/// A step of a converged implicit method takes a few of Newton's iterations, each with some 50 products of
/// conjugate gradients, and a product costs about as much as an evaluation of forces: see docs/stability.md.
constexpr double most_explicit_substeps = 200.0;

/// What contact puts back takes no part in an implicit step's equations: where cloth lies on something these
/// hardly ever converge, and a step takes as long as thousands of substeps (docs/stability.md).
constexpr double most_substeps_in_contact = 2000.0;

bool has_contact(const Scene& scene) {
  return std::any_of(scene.effects.begin(), scene.effects.end(), [](const Effect& effect) {
    const auto* collider = std::get_if<Collider>(&effect);
    return std::holds_alternative<SelfCollision>(effect) || (collider != nullptr && !is_penalty(*collider));
  });
}

/// Whether there is a force whose stiffness nobody knows: of a field that depends on the position.
bool has_field(const Scene& scene) {
  for (const Effect& effect : scene.effects) {
    const auto* field = std::get_if<Field>(&effect);
    if (field != nullptr && !std::holds_alternative<UniformField>(field->shape)) return true;
  }
  return false;
}

std::string because(double step, double longest, double substeps, bool is_explicit) {
  const std::string given = "a step of " + rounded_down(step) + " s";
  if (substeps == 1.0) return "verlet bears " + given + " whole: one evaluation of forces";
  const std::string needs = "verlet bears " + rounded_down(longest) + " s, so " + given + " needs " +
                            to_text(substeps) + " substeps";
  if (substeps <= most_explicit_substeps)
    return needs + ", fewer evaluations of forces than an implicit step takes";
  if (is_explicit) return needs + ", which implicit steps are slower than where there is contact";
  return needs + "; backward_euler takes it whole, and damps what it does not resolve";
}

}  // namespace

Recommendation recommended_method(const Scene& scene, double step) {
  const double longest = largest_stable_step(scene, Verlet{});
  const double substeps = needed_substeps(step, longest);
  const bool is_explicit =
      substeps <= (has_contact(scene) ? most_substeps_in_contact : most_explicit_substeps);
  std::string reason = because(step, longest, substeps, is_explicit);
  if (has_field(scene)) reason += "; the stiffness of its field is not known and not counted";
  if (is_explicit) return {Verlet{}, std::move(reason)};
  return {BackwardEuler{}, std::move(reason)};
}

}  // namespace hooke
