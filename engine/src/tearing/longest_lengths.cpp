#include "tearing/longest_lengths.h"

#include <algorithm>
#include <limits>

#include "effects/named_springs.h"

namespace hooke {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double longest_length(const Tearing& tearing, double stiffness, double rest) {
  const double by_strain = tearing.strain > 0.0 ? tearing.strain * rest : infinite;
  const double by_force = tearing.force > 0.0 && stiffness > 0.0 ? tearing.force / stiffness : infinite;
  return rest + std::min(by_strain, by_force);
}

}  // namespace

std::vector<double> longest_lengths(const Scene& scene) {
  const Springs& springs = scene.springs;
  std::vector<double> longest(springs.size(), infinite);
  for (const Effect& effect : scene.effects) {
    const auto* const tearing = std::get_if<Tearing>(&effect);
    if (tearing == nullptr) continue;
    for (const Index s : chosen_springs(tearing->springs, springs))
      longest[s] =
          std::min(longest[s], longest_length(*tearing, springs.stiffness[s], springs.rest_length[s]));
  }
  return longest;
}

bool may_tear(const Scene& scene) {
  return std::ranges::any_of(scene.effects,
                             [](const Effect& effect) { return std::holds_alternative<Tearing>(effect); });
}

}  // namespace hooke
