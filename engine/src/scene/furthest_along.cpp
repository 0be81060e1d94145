#include <algorithm>
#include <limits>
#include <utility>

#include <hooke/builders.h>

#include "scene/element_checks.h"

namespace hooke {
namespace {

void require_good(const Scene& scene, std::size_t first, std::size_t count, const Vec3& direction,
                  double distance) {
  std::vector<Fault> faults;
  const ElementChecks checks(faults, "furthest_along");
  checks.direction("direction", direction);
  checks.not_negative("distance", distance, "m");
  const std::size_t particles = scene.particles.size();
  if (count > 0 && first + count > particles) {
    checks.add("the last particle is " + std::to_string(first + count - 1) +
                   ", but the number of particles is " + std::to_string(particles),
               "give a range inside it");
  }
  throw_if_any(std::move(faults));
}

}  // namespace

std::vector<Index> furthest_along(const Scene& scene, Index first, Index count, const Vec3& direction,
                                  double distance) {
  require_good(scene, first, count, direction, distance);
  const Vec3 unit = direction.stableNormalized();
  const auto along = [&](Index i) { return unit.dot(scene.particles.position[first + i]); };
  double furthest = -std::numeric_limits<double>::infinity();
  for (Index i = 0; i < count; ++i) furthest = std::max(furthest, along(i));
  std::vector<Index> found;
  for (Index i = 0; i < count; ++i) {
    if (furthest - along(i) <= distance) found.push_back(first + i);
  }
  return found;
}

}  // namespace hooke
