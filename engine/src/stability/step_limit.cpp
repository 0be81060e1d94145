#include <limits>
#include <variant>

#include "stability/mode_limit.h"
#include "stability/scene_bounds.h"

namespace hooke {
namespace {

/// A method of one kick and one drift: its limit is known in closed form for all of a scene at once.
bool is_kick_and_drift(const Method& method) {
  return std::holds_alternative<SymplecticEuler>(method) || std::holds_alternative<Verlet>(method);
}

}  // namespace

double largest_stable_step(const SceneBounds& bounds, const Method& method) {
  if (std::holds_alternative<DormandPrince>(method) || solves_equations(method))
    return std::numeric_limits<double>::infinity();
  if (is_kick_and_drift(method)) return bounds.kick_and_drift;
  return longest_step(method, bounds.frequency, bounds.damping_rate);
}

double largest_stable_step(const Scene& scene, const Method& method) {
  return largest_stable_step(bounds_of(scene), method);
}

}  // namespace hooke
