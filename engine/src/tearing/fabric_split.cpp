// How what is at a particle is shared out between it and its new half.

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

#include "model/adjacency.h"
#include "tearing/fabric.h"

namespace hooke {

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

}  // namespace hooke
