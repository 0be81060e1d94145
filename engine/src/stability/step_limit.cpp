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

double largest_stable_step(const Scene& scene, const Method& method) {
  if (std::holds_alternative<DormandPrince>(method) || solves_equations(method))
    return std::numeric_limits<double>::infinity();
  if (is_kick_and_drift(method)) return longest_kick_and_drift(scene);
  return longest_step(method, highest_frequency(scene), highest_damping_rate(scene));
}

}  // namespace hooke
