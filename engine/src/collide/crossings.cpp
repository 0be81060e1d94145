#include "collide/crossings.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "collide/edge_crossing.h"

namespace hooke {
namespace {

/// Edges with triangles that one thread takes at a time, and groups of edges.
constexpr std::size_t in_run = 1024, groups_at_once = 8;

/// orientation() of the ends of two edges: exactly the same for an edge of two triangles, whichever way round
/// they name it.
double turn(const Places& x, Edge first, Edge second) {
  double sign = 1.0;
  if (first.first > first.second) std::swap(first.first, first.second), sign = -sign;
  if (second.first > second.second) std::swap(second.first, second.second), sign = -sign;
  if (second < first) std::swap(first, second);
  const double volume = orientation(x[first.first], x[first.second], x[second.first], x[second.second]);
  return sign * (volume == 0.0 ? std::numeric_limits<double>::denorm_min() : volume);
}

/// Six times the volume over a triangle, positive in front of it; of what lies in its plane, up to rounding,
/// too.
double height_over(const Places& x, const Triangle& triangle, Index particle) {
  const auto& [a, b, c] = triangle;
  const double volume = orientation(x[a], x[b], x[c], x[particle]);
  const double size = (x[b] - x[a]).norm() + (x[c] - x[a]).norm() + (x[particle] - x[a]).norm();
  const double rounding = 1e-14 * size * size * size;
  return volume > -rounding ? std::max(volume, rounding) : volume;
}

std::optional<Crossing> crossing_of(const Surface& surface, Index edge, Index triangle, const Places& x) {
  const auto [p, q] = surface.edges[edge];
  const auto& [a, b, c] = surface.triangles[triangle];
  const double before = height_over(x, surface.triangles[triangle], p),
               after = height_over(x, surface.triangles[triangle], q);
  if ((before > 0.0) == (after > 0.0)) return {};
  const std::array<double, 3> turns{turn(x, {p, q}, {b, c}), turn(x, {p, q}, {c, a}),
                                    turn(x, {p, q}, {a, b})};
  const bool left = turns[0] > 0.0;
  if ((turns[1] > 0.0) != left || (turns[2] > 0.0) != left) return {};
  const double sum = turns[0] + turns[1] + turns[2];
  return Crossing{
      edge, triangle, before / (before - after), {turns[0] / sum, turns[1] / sum, turns[2] / sum}};
}

/// Whether an edge and a triangle lie further apart than so much along an axis of any length [m]: then they
/// are.
bool are_apart_along(const Vec3& axis, const std::array<Vec3, 2>& edge, const std::array<Vec3, 3>& triangle,
                     double distance) {
  const auto [low, high] = std::minmax({axis.dot(edge[0]), axis.dot(edge[1])});
  const auto [other_low, other_high] =
      std::minmax({axis.dot(triangle[0]), axis.dot(triangle[1]), axis.dot(triangle[2])});
  const double gap = std::max(other_low - high, low - other_high);
  return gap > 0.0 && gap * gap > distance * distance * axis.squaredNorm();
}

/// Looks along the normal of the triangle and those of all edges in its plane: what lies flat beside it is
/// told from what is near it, which boxes do not tell.
bool are_apart(const Places& x, const Edge& edge, const Triangle& triangle, double distance) {
  const std::array ends{x[edge.first], x[edge.second]};
  const std::array corners{x[triangle[0]], x[triangle[1]], x[triangle[2]]};
  const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const auto along = [&](const Vec3& axis) { return are_apart_along(axis, ends, corners, distance); };
  return along(normal) || along(normal.cross(corners[1] - corners[0])) ||
         along(normal.cross(corners[2] - corners[1])) || along(normal.cross(corners[0] - corners[2])) ||
         along(normal.cross(ends[1] - ends[0]));
}

bool share_a_particle(const Edge& edge, const Triangle& triangle) {
  return std::any_of(triangle.begin(), triangle.end(),
                     [&](Index corner) { return corner == edge.first || corner == edge.second; });
}

/// Fills runs of the numbers below `count`, and puts them together in order.
template <class Item, class Add>
void gather_in_runs(std::size_t count, std::vector<std::vector<Item>>& runs, std::vector<Item>& all,
                    const Add& add, Executor& executor) {
  const std::size_t needed = (count + in_run - 1) / in_run;
  if (runs.size() < needed) runs.resize(needed);
  executor.parallel_for(needed, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t run = begin; run < end; ++run) {
      runs[run].clear();
      for (std::size_t i = run * in_run; i < std::min(count, (run + 1) * in_run); ++i) add(i, runs[run]);
    }
  });
  all.clear();
  for (std::size_t run = 0; run < needed; ++run) all.insert(all.end(), runs[run].begin(), runs[run].end());
}

}  // namespace

void Crossings::look(const BoxTree& edges, const BoxTree& triangles, const Places* at, double distance,
                     Executor& executor) {
  const auto may_cross = [&](Index edge, Index triangle) {
    const Edge& ends = surface_.edges[edge];
    const Triangle& corners = surface_.triangles[triangle];
    return !share_a_particle(ends, corners) && (at == nullptr || !are_apart(*at, ends, corners, distance));
  };
  near_runs_.resize(edges.groups());
  executor.parallel_for(edges.groups(), groups_at_once, [&](std::size_t begin, std::size_t end) {
    for (std::size_t g = begin; g < end; ++g) {
      NearRun& run = near_runs_[g];
      run.near.clear();
      triangles.for_each_meeting(edges, g, run.groups, [&](std::size_t place, Index triangle) {
        const Index edge = edges.group(g)[place];
        if (may_cross(edge, triangle)) run.near.emplace_back(edge, triangle);
      });
    }
  });
  near_.clear();
  for (const NearRun& run : near_runs_) near_.insert(near_.end(), run.near.begin(), run.near.end());
  std::sort(near_.begin(), near_.end());
}

const std::vector<Crossing>& Crossings::find(const Places& places, Executor& executor) {
  const auto add = [&](std::size_t i, std::vector<Crossing>& found) {
    const auto crossing = crossing_of(surface_, near_[i].first, near_[i].second, places);
    if (crossing) found.push_back(*crossing);
  };
  gather_in_runs(near_.size(), found_runs_, found_, add, executor);
  return found_;
}

std::size_t Crossings::bytes() const {
  std::size_t near = near_.capacity(), groups = 0, found = found_.capacity();
  for (const NearRun& run : near_runs_) near += run.near.capacity(), groups += run.groups.capacity();
  for (const auto& run : found_runs_) found += run.capacity();
  return near * sizeof(EdgeAndTriangle) + groups * sizeof(std::size_t) + found * sizeof(Crossing);
}

}  // namespace hooke
