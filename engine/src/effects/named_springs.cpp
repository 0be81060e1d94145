#include "effects/named_springs.h"

#include <algorithm>
#include <string>
#include <type_traits>
#include <variant>

namespace hooke {
namespace {

template <class Data>
inline constexpr bool changes_law = std::is_same_v<Data, Cables> || std::is_same_v<Data, StiffeningSprings> ||
                                    std::is_same_v<Data, Plasticity>;

bool has_rest_length(const Springs& springs, std::size_t spring) {
  return spring < springs.rest_length.size() && springs.rest_length[spring] > 0.0;
}

std::vector<Index> springs_of(const Cables& cables, const Springs&) {
  return cables.springs;
}

template <class Data>
std::vector<Index> springs_of(const Data& data, const Springs& springs) {
  return chosen_springs(data.springs, springs);
}

}  // namespace

std::vector<Index> chosen_springs(const std::vector<Index>& listed, const Springs& springs) {
  if (!listed.empty()) return listed;
  std::vector<Index> all;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    if (has_rest_length(springs, s)) all.push_back(Index(s));
  }
  return all;
}

std::vector<Index> creeping_springs(const Plasticity& plasticity, const Springs& springs) {
  if (plasticity.rate == 0.0 || plasticity.largest == 0.0) return {};
  std::vector<Index> creeping = chosen_springs(plasticity.springs, springs);
  std::erase_if(creeping, [&](Index s) { return springs.stiffness[s] == 0.0; });
  return creeping;
}

std::vector<bool> cable_mask(const Scene& scene) {
  std::vector<bool> mask;
  for (const Effect& effect : scene.effects) {
    const auto* const cables = std::get_if<Cables>(&effect);
    if (cables == nullptr || cables->springs.empty()) continue;
    mask.resize(scene.springs.size(), false);
    for (const Index spring : cables->springs) mask[spring] = true;
  }
  return mask;
}

void check_spring_list(const std::vector<Index>& listed, const Scene& scene, const ElementChecks& checks) {
  const std::size_t count = scene.springs.size();
  std::vector<bool> seen(listed.empty() ? 0 : count, false);
  for (std::size_t i = 0; i < listed.size(); ++i) {
    checks.in_range("springs[" + std::to_string(i) + "]", listed[i], count, "springs");
    if (listed[i] >= count) continue;
    if (seen[listed[i]])
      checks.add("springs names spring " + std::to_string(listed[i]) + " twice", "name it once");
    seen[listed[i]] = true;
  }
}

void check_strained_springs(const std::vector<Index>& listed, const Scene& scene,
                            const ElementChecks& checks) {
  check_spring_list(listed, scene, checks);
  for (const Index spring : listed) {
    if (spring >= scene.springs.size() || has_rest_length(scene.springs, spring)) continue;
    checks.add("spring " + std::to_string(spring) + " has no rest length, and so no strain",
               "give it a rest_length > 0 or leave it out of springs");
  }
}

template <class Data>
void check_only_law(const Data& data, const Scene& scene, const ElementChecks& checks) {
  const std::size_t count = scene.springs.size();
  std::vector<bool> own(count, false);
  for (const Index spring : springs_of(data, scene.springs)) {
    if (spring < count) own[spring] = true;
  }
  for (const Effect& effect : scene.effects) {
    if (std::get_if<Data>(&effect) == &data) return;
    const auto check = [&]<class Other>(const Other& other) {
      if constexpr (changes_law<Other>) {
        const std::vector<Index> others = springs_of(other, scene.springs);
        const auto both =
            std::find_if(others.begin(), others.end(), [&](Index s) { return s < count && own[s]; });
        if (both == others.end()) return;
        checks.add(
            "spring " + std::to_string(*both) + " has another law already, by " + std::string(Other::name),
            "name each spring in one of cables, stiffening_springs and plasticity");
      }
    };
    std::visit(check, effect);
  }
}

template void check_only_law(const Cables&, const Scene&, const ElementChecks&);
template void check_only_law(const StiffeningSprings&, const Scene&, const ElementChecks&);
template void check_only_law(const Plasticity&, const Scene&, const ElementChecks&);

}  // namespace hooke
