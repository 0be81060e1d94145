#include "collide/untangling.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace hooke {
namespace {

/// An edge that is nearly in the plane of the triangle that it crosses would have to move far along it.
constexpr double least_slope = 0.1;

}  // namespace

bool Untangling::look(const Places& places, Executor& executor) {
  pulls_.clear();
  is_tangled_ = false;
  if (crossings_.none_near()) return false;
  const std::vector<Crossing>& found = crossings_.find(places, executor);
  if (found.empty()) return false;
  is_tangled_ = true;
  const auto at = curves_.trace(found, places);
  for (std::size_t c = 0; c < found.size(); ++c) {
    const SurfaceContact pull = pull_of(found[c], at[c], places);
    if (pull.least > 0.0 && can_be_moved(pull, inverse_mass_)) pulls_.push_back(pull);
  }
  return true;
}

/// From the end of the edge that is inside, else from the nearer one, and the triangle. `least` is how far
/// they ought to move.
SurfaceContact Untangling::pull_of(const Crossing& crossing, const IntersectionCurves::Place& place,
                                   const Places& places) const {
  const auto [p, q] = surface_.edges[crossing.edge];
  const auto& [a, b, c] = surface_.triangles[crossing.triangle];
  const auto& [wa, wb, wc] = crossing.weights;
  const Vec3 way = places[q] - places[p];
  const Vec3 normal = (places[b] - places[a]).cross(places[c] - places[a]).stableNormalized();
  const bool is_open = place.inside != p && place.inside != q;
  const Index end = is_open ? (crossing.along < 0.5 ? p : q) : place.inside;
  SurfaceContact pull{{end, a, b, c}, {1.0, -wa, -wb, -wc}, Vec3::Zero(), 0.0, Vec3::Zero(), 0.0};
  if (is_open) {
    const Vec3 along = way.stableNormalized();
    const double slope = along.dot(normal);
    const double bounded = std::copysign(std::max(std::abs(slope), least_slope), slope);
    const Vec3 shorter = place.onwards - along.dot(place.onwards) / bounded * normal;
    pull.normal = shorter.stableNormalized();
    pull.least = std::min(shorter.norm(), 1.0) * way.norm();
  } else {
    const double outwards = (end == p ? 1.0 : -1.0) * way.dot(normal);
    pull.normal = outwards < 0.0 ? (-normal).eval() : normal;
    const double inside = end == p ? crossing.along : 1.0 - crossing.along;
    pull.least = inside * std::abs(outwards) + thickness_;
  }
  return pull;
}

const Places& Untangling::draw_apart(Places& places, double furthest) {
  for (SurfaceContact& pull : pulls_) pull.least = std::min(pull.least, furthest);
  const Places& move = move_.solve(pulls_);
  for (const Index i : surface_.corners) places[i] += move[i];
  for (SurfaceContact& pull : pulls_) pull.least = 0.0;
  return move;
}

}  // namespace hooke
