// What is at each particle, and which cut a torn spring makes there. What the cut does: fabric_split.cpp.

#include "tearing/fabric.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "effects/immovable.h"
#include "model/adjacency.h"
#include "tearing/longest_lengths.h"
#include "tearing/renumbered_effects.h"

namespace hooke {
namespace {

/// Of a list that may be empty.
template <class Value>
void drop(const std::vector<bool>& gone, std::vector<Value>& list) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!gone[i]) list[kept++] = list[i];
  }
  list.resize(kept);
}

}  // namespace

unsigned Fabric::Plane::sides_of(const Vec3& place) const {
  constexpr double rounding = 1e-6;
  const Vec3 way = place - origin;
  const double height = normal.dot(way), in_plane = rounding * way.norm();
  return (height > in_plane ? 0u : near_side) | (height < -in_plane ? 0u : far_side);
}

Fabric::Fabric(const Scene& scene, std::vector<Vec3> positions)
    : scene_(scene),
      positions_(std::move(positions)),
      springs_before_(scene.springs.size()),
      springs_at_(scene.particles.size()),
      triangles_at_(scene.particles.size()),
      held_(fixed_particles(scene)),
      torn_at_(scene.particles.size(), false),
      gone_(scene.springs.size(), false),
      spring_from_(scene.springs.size()) {
  for (Index s = 0; s < springs_before_; ++s) {
    spring_from_[s] = s;
    for (const Index end : ends(s)) springs_at_[end].push_back(s);
  }
  for (Index t = 0; t < scene_.triangles.size(); ++t) {
    for (const Index corner : scene_.triangles[t]) triangles_at_[corner].push_back(t);
  }
  find_lines();
}

void Fabric::find_lines() {
  for (std::size_t effect = 0; effect < scene_.effects.size(); ++effect) {
    const auto* const bending = std::get_if<LaplacianBending>(&scene_.effects[effect]);
    if (bending == nullptr) continue;
    lines_at_.resize(positions_.size());
    for (std::size_t line = 0; line < bending->middle.size(); ++line) {
      for (const auto* list : {&bending->first, &bending->middle, &bending->last})
        lines_at_[(*list)[line]].push_back({effect, line});
    }
  }
}

bool Fabric::has_corner(Index triangle, Index particle) const {
  const Triangle& corners = scene_.triangles[triangle];
  return std::ranges::find(corners, particle) != corners.end();
}

std::vector<Index> Fabric::corners_of(const std::vector<Index>& triangles, Index without) const {
  std::vector<Index> corners;
  for (const Index t : triangles) {
    for (const Index corner : scene_.triangles[t]) {
      if (corner != without && !contains(corners, corner)) corners.push_back(corner);
    }
  }
  return corners;
}

bool Fabric::share_triangle(Index a, Index b) const {
  return std::ranges::any_of(triangles_at_[a], [&](Index t) { return has_corner(t, b); });
}

bool Fabric::two_edges_lead(Index a, Index b) const {
  return std::ranges::any_of(corners_of(triangles_at_[a], a),
                             [&](Index corner) { return corner != b && share_triangle(corner, b); });
}

/// On which sides of a cut an edge leads to a particle.
unsigned Fabric::edge_sides(Index end, const Cut& cut) const {
  const auto leads = [&](Index t) { return has_corner(t, end); };
  return (std::ranges::any_of(cut.near_triangles, leads) ? near_side : 0u) |
         (std::ranges::any_of(cut.far_triangles, leads) ? far_side : 0u);
}

/// On which sides two edges do.
unsigned Fabric::led_sides(Index end, const Cut& cut) const {
  const auto leads = [&](const std::vector<Index>& triangles) {
    return std::ranges::any_of(corners_of(triangles, cut.particle),
                               [&](Index corner) { return share_triangle(corner, end); });
  };
  return (leads(cut.near_triangles) ? near_side : 0u) | (leads(cut.far_triangles) ? far_side : 0u);
}

Fabric::Plane Fabric::plane_across(Index particle, Index spring) const {
  const Index other = other_end(scene_.springs, spring, particle);
  return {positions_[particle], (positions_[other] - positions_[particle]).stableNormalized()};
}

void Fabric::share_triangles(Index other_end, Cut& cut) const {
  for (const Index t : triangles_at_[cut.particle]) {
    const auto& [a, b, c] = scene_.triangles[t];
    const Vec3 centre = (positions_[a] + positions_[b] + positions_[c]) / 3.0;
    const bool is_far = has_corner(t, other_end) || cut.plane.sides_of(centre) == far_side;
    (is_far ? cut.far_triangles : cut.near_triangles).push_back(t);
  }
  cut.near_parts = cut.near_triangles.size();
  cut.far_parts = cut.far_triangles.size();
}

void Fabric::share_springs(Index torn, Cut& cut) const {
  for (const Index s : springs_at_[cut.particle]) {
    const Index end = other_end(scene_.springs, s, cut.particle);
    const unsigned by_place = cut.plane.sides_of(positions_[end]);
    unsigned sides = edge_sides(end, cut);
    if (sides == (near_side | far_side)) {
      cut.shared_springs.push_back(s);
      continue;
    }
    if (sides == 0) {
      sides = led_sides(end, cut);
      if (sides != 0) cut.led_springs.push_back(s);
      if (sides == 0) ++(by_place == far_side ? cut.far_parts : cut.near_parts);
      if (sides == 0 || sides == (near_side | far_side)) sides = by_place;
    }
    if (sides == far_side || s == torn) cut.far_springs.push_back(s);
  }
}

Fabric::Cut Fabric::cut_at(Index particle, Index spring) const {
  Cut cut{particle, plane_across(particle, spring), {}, {}, {}, {}, {}};
  share_triangles(other_end(scene_.springs, spring, particle), cut);
  share_springs(spring, cut);
  return cut;
}

/// Whether one of its edges is of one triangle only.
bool Fabric::at_border(Index particle) const {
  const std::vector<Index>& around = triangles_at_[particle];
  return std::ranges::any_of(corners_of(around, particle), [&](Index corner) {
    return std::ranges::count_if(around, [&](Index t) { return has_corner(t, corner); }) == 1;
  });
}

bool Fabric::is_better(const Cut& cut, const Cut& other) const {
  const auto key = [&](const Cut& of) {
    return std::tuple(of.splits(), !held_[of.particle], at_border(of.particle),
                      std::min(of.near_parts, of.far_parts));
  };
  const auto own = key(cut), others = key(other);
  return own != others ? own > others : cut.particle < other.particle;
}

void Fabric::tear(Index spring) {
  const auto [a, b] = ends(spring);
  if (gone_[spring] || torn_at_[a] || torn_at_[b]) return;
  const Cut at_a = cut_at(a, spring), at_b = cut_at(b, spring);
  const Cut& best = is_better(at_b, at_a) ? at_b : at_a;
  torn_at_[a] = torn_at_[b] = true;
  if (best.splits()) {
    split(best);
  } else if (is_edge(spring)) {
    unsplit_.push_back(spring);
  } else {
    remove(spring);
  }
}

void Fabric::drop_lines() {
  std::vector<std::vector<bool>> gone(scene_.effects.size());
  for (const Line& line : gone_lines_) {
    auto& bending = std::get<LaplacianBending>(scene_.effects[line.effect]);
    gone[line.effect].resize(bending.stiffness.size(), false);
    gone[line.effect][line.number] = true;
  }
  for (std::size_t effect = 0; effect < gone.size(); ++effect) {
    if (gone[effect].empty()) continue;
    auto& bending = std::get<LaplacianBending>(scene_.effects[effect]);
    for (auto* list : {&bending.first, &bending.middle, &bending.last}) drop(gone[effect], *list);
    drop(gone[effect], bending.stiffness);
  }
}

/// Springs beside a tear have lost what they were strained against. They get a quarter more of stretch before
/// they tear, until they have relaxed: else a tear would run on within the steps in which they do. So do
/// those that found nothing to be split, or they would be looked at in each step.
std::vector<RelaxingSpring> Fabric::relaxing_springs(const Scene& torn,
                                                     const std::vector<Index>& number_after) const {
  constexpr double more = 1.25;
  const Springs& springs = torn.springs;
  const std::vector<double> longest = longest_lengths(torn);
  std::vector<bool> split(positions_.size(), false);
  for (const Index particle : split_from_) split[particle] = true;
  std::fill(split.end() - std::ptrdiff_t(split_from_.size()), split.end(), true);
  std::vector<bool> unsplit(springs.size(), false);
  for (const Index s : unsplit_) unsplit[number_after[s]] = true;
  std::vector<RelaxingSpring> relaxing;
  for (Index s = 0; s < springs.size(); ++s) {
    const Index a = springs.first[s], b = springs.second[s];
    if (std::isinf(longest[s]) || !(split[a] || split[b] || unsplit[s])) continue;
    const double rest = springs.rest_length[s], length = (positions_[b] - positions_[a]).norm();
    relaxing.push_back({s, rest + more * (std::max(length, longest[s]) - rest)});
  }
  return relaxing;
}

TornScene Fabric::finish() && {
  TornScene torn;
  torn.number_after.assign(springs_before_, TornScene::none);
  for (Index s = 0; s < gone_.size(); ++s) {
    if (gone_[s]) continue;
    if (s < springs_before_) torn.number_after[s] = Index(torn.spring_from.size());
    torn.spring_from.push_back(spring_from_[s]);
  }
  Springs& springs = scene_.springs;
  for (auto* list : {&springs.first, &springs.second}) drop(gone_, *list);
  for (auto* list : {&springs.stiffness, &springs.rest_length, &springs.damping}) drop(gone_, *list);
  drop_lines();
  renumber_effects({springs_before_, torn.spring_from, split_from_}, scene_);
  torn.relaxing = relaxing_springs(scene_, torn.number_after);
  torn.scene = std::move(scene_);
  torn.split_from = std::move(split_from_);
  return torn;
}

}  // namespace hooke
