#include "scene/room.h"

#include <algorithm>
#include <limits>
#include <string>

#include "scene/element_checks.h"
#include "scene/number_text.h"

namespace hooke {
namespace {

template <class T>
void reserve_more(std::vector<T>& values, double extra) {
  const std::size_t needed = values.size() + static_cast<std::size_t>(extra);
  if (needed > values.capacity()) values.reserve(std::max(needed, values.size() + values.size() / 2));
}

}  // namespace

void check_room(std::vector<Fault>& faults, std::string_view builder, const Scene& scene,
                const Counts& extra) {
  constexpr double most = std::numeric_limits<Index>::max();
  const auto check = [&](std::size_t present, double added, const std::string& plural) {
    const double total = static_cast<double>(present) + added;
    if (total <= most) return;
    ElementChecks(faults, builder)
        .add("makes a scene of " + to_text(total) + " " + plural, "make it of at most " + to_text(most));
  };
  check(scene.particles.size(), extra.particles, "particles");
  check(scene.springs.size(), extra.springs, "springs");
  check(scene.triangles.size(), extra.triangles, "triangles");
}

void reserve_room(Scene& scene, const Counts& extra, bool damped) {
  auto& [mass, position, velocity] = scene.particles;
  reserve_more(mass, extra.particles);
  reserve_more(position, extra.particles);
  if (!velocity.empty()) reserve_more(velocity, extra.particles);

  Springs& springs = scene.springs;
  reserve_more(springs.first, extra.springs);
  reserve_more(springs.second, extra.springs);
  reserve_more(springs.stiffness, extra.springs);
  reserve_more(springs.rest_length, extra.springs);
  if (!springs.damping.empty()) {
    reserve_more(springs.damping, extra.springs);
  } else if (damped) {
    springs.damping.reserve(springs.first.capacity());  // the first damped spring fills it for all before it
  }
  reserve_more(scene.triangles, extra.triangles);
}

}  // namespace hooke
