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

bool contains(const std::vector<Index>& list, Index one) {
  return std::ranges::find(list, one) != list.end();
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

double Fabric::area_at_rest(const std::vector<Index>& triangles) const {
  const std::vector<Vec3>& rest = scene_.particles.position;
  double area = 0.0;
  for (const Index t : triangles) {
    const auto& [a, b, c] = scene_.triangles[t];
    area += 0.5 * (rest[b] - rest[a]).cross(rest[c] - rest[a]).norm();
  }
  return area;
}

double Fabric::far_share_of_mass(const Cut& cut) const {
  const double near = area_at_rest(cut.near_triangles), far = area_at_rest(cut.far_triangles);
  const bool by_area = near > 0.0 && far > 0.0;
  return by_area ? far / (near + far) : double(cut.far_parts) / double(cut.near_parts + cut.far_parts);
}

Index Fabric::add_particle(const Cut& cut) {
  Particles& particles = scene_.particles;
  const Index from = cut.particle;
  const double mass = particles.mass[from] * far_share_of_mass(cut);
  const Vec3 place = particles.position[from];
  particles.mass[from] -= mass;
  particles.mass.push_back(mass);
  particles.position.push_back(place);
  if (!particles.velocity.empty()) particles.velocity.push_back(Vec3(particles.velocity[from]));
  positions_.push_back(Vec3(positions_[from]));
  springs_at_.emplace_back();
  triangles_at_.emplace_back();
  if (!lines_at_.empty()) lines_at_.emplace_back();
  held_.push_back(false);
  torn_at_.push_back(true);
  split_from_.push_back(from);
  return Index(particles.size() - 1);
}

void Fabric::put_end(Index spring, Index from, Index to) {
  Springs& springs = scene_.springs;
  (springs.first[spring] == from ? springs.first : springs.second)[spring] = to;
  springs_at_[to].push_back(spring);
}

/// The part of a spring on the far side is a new one.
void Fabric::share_out_spring(Index spring, const Cut& cut, Index added) {
  Springs& springs = scene_.springs;
  const Index end = other_end(springs, spring, cut.particle);
  const auto leads = [&](Index t) { return has_corner(t, end); };
  const auto near = double(std::ranges::count_if(cut.near_triangles, leads));
  const auto far = double(std::ranges::count_if(cut.far_triangles, leads));
  const double share = far / (near + far);
  const Index part =
      scene_.add_spring(springs.first[spring], springs.second[spring], share * springs.stiffness[spring],
                        springs.rest_length[spring], share * springs.damping_of(spring));
  springs.stiffness[spring] *= 1.0 - share;
  if (!springs.damping.empty()) springs.damping[spring] *= 1.0 - share;
  gone_.push_back(false);
  spring_from_.push_back(spring_from_[spring]);
  springs_at_[end].push_back(part);
  put_end(part, cut.particle, added);
}

void Fabric::remove(Index spring) {
  gone_[spring] = true;
  for (const Index end : ends(spring)) std::erase(springs_at_[end], spring);
}

/// Springs between corners around the particle, which two edges by way of it may have led along.
std::vector<Index> Fabric::across(const Cut& cut) const {
  std::vector<Index> found;
  const std::vector<Index> around = corners_of(triangles_at_[cut.particle], cut.particle);
  for (const Index corner : around) {
    for (const Index s : springs_at_[corner]) {
      const Index end = other_end(scene_.springs, s, corner);
      if (corner < end && contains(around, end) && !is_edge(s)) found.push_back(s);
    }
  }
  return found;
}

/// Where there are no triangles: springs that at rest lie over the particle, from one side to the other.
std::vector<Index> Fabric::straight_through(const Cut& cut) const {
  constexpr double bend = 1.01;  // of the way by the particle over the straight one
  std::vector<Index> found, near_ends, far_ends;
  const std::vector<Vec3>& rest = scene_.particles.position;
  for (const Index s : springs_at_[cut.particle]) {
    const bool is_far = contains(cut.far_springs, s);
    (is_far ? far_ends : near_ends).push_back(other_end(scene_.springs, s, cut.particle));
  }
  for (const Index near : near_ends) {
    for (const Index s : springs_at_[near]) {
      const Index far = other_end(scene_.springs, s, near);
      if (!contains(far_ends, far)) continue;
      const Vec3 place = rest[cut.particle];
      const double by_it = (rest[near] - place).norm() + (rest[far] - place).norm();
      if (by_it <= bend * (rest[near] - rest[far]).norm()) found.push_back(s);
    }
  }
  return found;
}

void Fabric::split(const Cut& cut) {
  const bool has_triangles = !triangles_at_[cut.particle].empty();
  const std::vector<Index> crossing = has_triangles ? across(cut) : straight_through(cut);
  const Index added = add_particle(cut);
  for (const Index t : cut.far_triangles) {
    std::ranges::replace(scene_.triangles[t], cut.particle, added);
    triangles_at_[added].push_back(t);
  }
  triangles_at_[cut.particle] = cut.near_triangles;
  for (const Index s : cut.far_springs) {
    put_end(s, cut.particle, added);
    std::erase(springs_at_[cut.particle], s);
  }
  for (const Index s : cut.shared_springs) share_out_spring(s, cut, added);
  if (!lines_at_.empty()) share_out_lines(cut, added);
  const auto bridges = [&](Index s) { return !has_triangles || !two_edges_lead(ends(s)[0], ends(s)[1]); };
  for (const Index s : crossing) {
    if (bridges(s)) remove(s);
  }
  for (const Index s : cut.led_springs) {
    if (bridges(s)) remove(s);
  }
}

/// On which sides of a cut something leads to a particle, the nearest first.
unsigned Fabric::sides_of(Index end, const Cut& cut) const {
  if (const unsigned sides = edge_sides(end, cut); sides != 0) return sides;
  if (const unsigned sides = led_sides(end, cut); sides != 0) return sides;
  return cut.plane.sides_of(positions_[end]);
}

void Fabric::share_out_lines(const Cut& cut, Index added) {
  const std::vector<Line> lines = std::exchange(lines_at_[cut.particle], {});
  for (const Line& line : lines) {
    auto& bending = std::get<LaplacianBending>(scene_.effects[line.effect]);
    const unsigned side = side_of_line(bending, line.number, cut);
    if (side == 0) gone_lines_.push_back(line);
    if (side == 0) continue;
    lines_at_[side == far_side ? added : cut.particle].push_back(line);
    if (side == near_side) continue;
    for (auto* list : {&bending.first, &bending.middle, &bending.last}) {
      if ((*list)[line.number] == cut.particle) (*list)[line.number] = added;
    }
  }
}

/// Where a line of three at the particle stays whole; 0 where it leads across the cut.
unsigned Fabric::side_of_line(const LaplacianBending& bending, std::size_t line, const Cut& cut) const {
  const Index first = bending.first[line], middle = bending.middle[line], last = bending.last[line];
  unsigned sides;
  if (middle == cut.particle) {
    sides = sides_of(first, cut) & sides_of(last, cut);
  } else {
    sides = sides_of(middle, cut);
    if (sides == (near_side | far_side))
      sides = cut.plane.sides_of(positions_[first == cut.particle ? last : first]);
  }
  return (sides & near_side) != 0 ? unsigned(near_side) : sides;
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
