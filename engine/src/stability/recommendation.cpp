#include <string>
#include <variant>

#include <hooke/stability.h>

#include "scene/number_text.h"
#include "stability/scene_bounds.h"
#include "stability/step_division.h"

namespace hooke {
namespace {

/// A step of a converged implicit method takes a few of Newton's iterations, each with some 50 products of
/// conjugate gradients, and a product costs about as much as an evaluation of forces: see docs/stability.md.
constexpr double most_explicit_substeps = 200.0;

/// Whether there is a force whose stiffness nobody knows: of a field that depends on the position.
bool has_field(const Scene& scene) {
  for (const Effect& effect : scene.effects) {
    const auto* field = std::get_if<Field>(&effect);
    if (field != nullptr && !std::holds_alternative<UniformField>(field->shape)) return true;
  }
  return false;
}

std::string because(double step, double longest, double substeps) {
  const std::string given = "a step of " + rounded_down(step) + " s";
  if (substeps == 1.0) return "verlet bears " + given + " whole: one evaluation of forces";
  const std::string needs = "verlet bears " + rounded_down(longest) + " s, so " + given + " needs " +
                            to_text(substeps) + " substeps";
  if (substeps <= most_explicit_substeps) {
    return needs + ", fewer evaluations of forces than an implicit step takes";
  }
  return needs + "; backward_euler takes it whole, and damps what it does not resolve";
}

}  // namespace

Recommendation recommended_method(const Scene& scene, double step) {
  const double longest = largest_stable_step(scene, Verlet{});
  const double substeps = needed_substeps(step, longest);
  std::string reason = because(step, longest, substeps);
  if (has_field(scene)) reason += "; the stiffness of its field is not known and not counted";
  if (substeps <= most_explicit_substeps) return {Verlet{}, std::move(reason)};
  return {BackwardEuler{}, std::move(reason)};
}

}  // namespace hooke
