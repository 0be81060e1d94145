#include "tearing/renumbered_effects.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "effects/tether_lengths.h"

namespace hooke {
namespace {

/// In place of an effect that had a list and has nothing left in it: an empty list would mean everything.
Effect nothing() {
  return Cables{};
}

/// In ascending order.
std::vector<Index> renumbered_springs(const std::vector<Index>& listed, const Renumbering& renumbering) {
  std::vector<bool> is_listed(renumbering.springs_before, false);
  for (const Index s : listed) is_listed[s] = true;
  std::vector<Index> now;
  for (std::size_t s = 0; s < renumbering.spring_from.size(); ++s) {
    if (is_listed[renumbering.spring_from[s]]) now.push_back(Index(s));
  }
  return now;
}

/// With the new particles whose originals are in the list.
void add_parts(std::vector<Index>& listed, const Renumbering& renumbering, std::size_t particles) {
  std::vector<bool> is_listed(particles, false);
  for (const Index particle : listed) is_listed[particle] = true;
  const std::size_t before = particles - renumbering.split_from.size();
  for (std::size_t i = 0; i < renumbering.split_from.size(); ++i) {
    if (is_listed[renumbering.split_from[i]]) listed.push_back(Index(before + i));
  }
}

/// An effect of another kind has nothing to be carried over. Returns whether something is left of it.
template <class Data>
bool carry_over(Data& data, const Renumbering& renumbering, const Scene&) {
  if constexpr (requires { data.springs; }) {
    if (data.springs.empty()) return true;
    data.springs = renumbered_springs(data.springs, renumbering);
    return !data.springs.empty();
  }
  return true;
}

bool carry_over(ForceScript& script, const Renumbering& renumbering, const Scene& scene) {
  add_parts(script.particles, renumbering, scene.particles.size());
  return true;
}

/// What has been torn off all pins is no longer held.
bool carry_over(Tethers& tethers, const Renumbering& renumbering, const Scene& scene) {
  if (tethers.particles.empty()) return true;
  add_parts(tethers.particles, renumbering, scene.particles.size());
  const std::vector<WayToPin> ways = ways_to_pins(scene);
  std::erase_if(tethers.particles, [&](Index i) { return ways[i].pin == WayToPin::no_pin; });
  return !tethers.particles.empty();
}

/// A new particle begins where its other part is: spheres around both would push each other apart.
bool carry_over(ParticleContact& contact, const Renumbering& renumbering, const Scene& scene) {
  if (!contact.particles.empty()) return true;
  contact.particles.resize(scene.particles.size() - renumbering.split_from.size());
  std::iota(contact.particles.begin(), contact.particles.end(), Index{0});
  return true;
}

}  // namespace

void renumber_effects(const Renumbering& renumbering, Scene& scene) {
  for (Effect& effect : scene.effects) {
    const bool any_left =
        std::visit([&](auto& data) { return carry_over(data, renumbering, scene); }, effect);
    if (!any_left) effect = nothing();
  }
}

}  // namespace hooke
