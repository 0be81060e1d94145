#include "sleep/islands.h"

#include <algorithm>
#include <variant>

#include "sleep/joined_parts.h"

namespace hooke {
namespace {

void join_surface(const std::vector<Index>& listed, const Scene& scene, JoinedParts& parts) {
  if (scene.triangles.empty()) return;
  const Index one = scene.triangles[listed.empty() ? 0 : listed.front()][0];
  const auto join = [&](const Triangle& triangle) { parts.join(one, triangle[0]); };
  if (listed.empty()) std::ranges::for_each(scene.triangles, join);
  for (const Index t : listed) join(scene.triangles[t]);
}

/// What effects join that no spring or triangle does.
struct JoinByEffect {
  const Scene& scene;
  JoinedParts& parts;

  void operator()(const LaplacianBending& bending) const {
    for (std::size_t i = 0; i < bending.middle.size(); ++i) {
      parts.join(bending.first[i], bending.middle[i]);
      parts.join(bending.middle[i], bending.last[i]);
    }
  }
  void operator()(const Stitch& stitch) const {
    for (std::size_t i = 0; i < stitch.first.size(); ++i) parts.join(stitch.first[i], stitch.second[i]);
  }
  void operator()(const Pressure& pressure) const { join_surface(pressure.triangles, scene, parts); }
  void operator()(const Volume& volume) const { join_surface(volume.triangles, scene, parts); }
  void operator()(const auto&) const {}
};

JoinedParts joined_parts(const Scene& scene) {
  JoinedParts parts(scene.particles.size());
  for (std::size_t s = 0; s < scene.springs.size(); ++s)
    parts.join(scene.springs.first[s], scene.springs.second[s]);
  for (const Triangle& triangle : scene.triangles) {
    parts.join(triangle[0], triangle[1]);
    parts.join(triangle[0], triangle[2]);
  }
  for (const Effect& effect : scene.effects) std::visit(JoinByEffect{scene, parts}, effect);
  return parts;
}

}  // namespace

Islands::Islands(const Scene& scene) : of_(scene.particles.size()) {
  JoinedParts parts = joined_parts(scene);
  Index islands = 0;
  for (Index i = 0; i < of_.size(); ++i) {
    const Index lowest = parts.lowest(i);
    of_[i] = lowest == i ? islands++ : of_[lowest];
  }
  sleeps_.assign(islands, 0);
}

void Islands::set(Index island, bool sleeps) {
  if (this->sleeps(island) == sleeps) return;
  sleeps_[island] = sleeps ? 1 : 0;
  asleep_ = sleeps ? asleep_ + 1 : asleep_ - 1;
  ++changes_;
}

std::shared_ptr<Islands> islands_of(const Scene& scene) {
  const auto sleeps = [](const Effect& effect) { return std::holds_alternative<Sleep>(effect); };
  return std::ranges::any_of(scene.effects, sleeps) ? std::make_shared<Islands>(scene) : nullptr;
}

}  // namespace hooke
