#include "collide/mesh_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hooke {
namespace {

/// A cell's side over the length of a square as large as a mean triangle: half an edge of even triangles.
constexpr double cell_over_triangle = 0.75;

/// As deep as this below the surface, in cells, lists are kept; particles seldom get deeper.
constexpr double listed_depth = 0.25;

double area_of(const std::vector<TriangleCorners>& triangles) {
  double twice = 0.0;
  for (const auto& [a, b, c] : triangles) twice += (b - a).cross(c - a).norm();
  return 0.5 * twice;
}

Eigen::AlignedBox3d box_around(const std::vector<TriangleCorners>& triangles) {
  Eigen::AlignedBox3d box;
  for (const TriangleCorners& corners : triangles) {
    for (const Vec3& corner : corners) box.extend(corner);
  }
  return box;
}

struct Ball {
  Vec3 middle;
  double radius;
};

Ball ball_around(const TriangleCorners& t) {
  const Vec3 middle = (t[0] + t[1] + t[2]) / 3.0;
  return {middle, std::max({(t[0] - middle).norm(), (t[1] - middle).norm(), (t[2] - middle).norm()})};
}

/// From the middles of triangles straight through to the other side.
double least_thickness(const TriangleTree& tree) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : tree.triangles()) {
    const Vec3 normal = (b - a).cross(c - a).stableNormalized();
    if (normal.squaredNorm() > 0.5) least = std::min(least, tree.way_out((a + b + c) / 3.0, -normal));
  }
  return least;
}

}  // namespace

/// Fills the grid from the top down: each part of a brick passes on the triangles that can be nearest to its
/// points to its eighths.
template <class Real>
class MeshDistance<Real>::Builder {
 public:
  Builder(MeshDistance& mesh, const WeldedSurface& surface, double reach)
      : mesh_(mesh), surface_(surface_triangles<double>(surface)), reach_(reach) {
    balls_.reserve(surface_.size());
    for (const TriangleCorners& corners : mesh_.tree_.triangles()) balls_.push_back(ball_around(corners));
    place_grid();
    for (int z = 0; z < mesh_.bricks_[2]; ++z) {
      for (int y = 0; y < mesh_.bricks_[1]; ++y) {
        for (int x = 0; x < mesh_.bricks_[0]; ++x) add_brick(Place(x, y, z));
      }
    }
  }

 private:
  void place_grid() {
    const std::vector<TriangleCorners>& triangles = mesh_.tree_.triangles();
    const Eigen::AlignedBox3d box = box_around(triangles);
    const double most_bricks = std::max(4096.0, 2.0 * double(triangles.size()));
    cell_ = std::max({cell_over_triangle * std::sqrt(area_of(triangles) / double(triangles.size())),
                      0.5 * reach_, 1e-3 * box.sizes().maxCoeff()});
    Vec3 size;
    double margin = 0.0;
    for (;; cell_ *= 1.25) {
      margin = reach_ + cell_;
      size = ((box.sizes().array() + 2.0 * margin) / (brick * cell_)).ceil();
      low_ = box.min() - Vec3::Constant(margin);
      if (size.prod() <= most_bricks) break;
    }
    slack_ = 6.0 * double(std::numeric_limits<Real>::epsilon()) * box.sizes().maxCoeff();
    mesh_.low_ = low_.template cast<Real>();
    mesh_.margin_ = Real(margin);
    mesh_.reach_ = Real(reach_);
    mesh_.slack_ = Real(slack_);
    mesh_.cell_ = Real(cell_);
    mesh_.inverse_cell_ = Real(1.0 / cell_);
    mesh_.bricks_ = size.template cast<int>();
  }

  /// The middle of a cube of cells.
  Vec3 middle(const Place& first, int size) const {
    return low_ + cell_ * (first.template cast<double>() + Vec3::Constant(0.5 * size));
  }

  /// From the middle to a corner.
  double radius(int size) const { return 0.5 * std::sqrt(3.0) * size * cell_ + slack_; }

  double signed_distance(Index triangle, const Vec3& point) const {
    const SurfaceTriangle<double>& nearest = surface_[triangle];
    return nearest.seen_from(nearest.closest_to(point), point).distance(point);
  }

  bool is_far(double distance, int size) const {
    const double beyond = distance > 0.0 ? reach_ : listed_depth * cell_;
    return std::abs(distance) - radius(size) >= beyond + slack_;
  }

  void add_brick(const Place& place) {
    const Place first = brick * place;
    const Vec3 point = middle(first, brick);
    const double distance = signed_distance(mesh_.tree_.nearest(point), point);
    Brick added{safe(distance), -1};
    if (!is_far(distance, brick)) {
      added.first_cell = std::int32_t(mesh_.cells_.size());
      mesh_.cells_.resize(mesh_.cells_.size() + brick_cells);
      cells_of_brick_ = mesh_.cells_.data() + added.first_cell;
      first_in_brick_ = first;
      divide(first, brick, mesh_.tree_.within(point, std::abs(distance) + 2.0 * radius(brick)));
    }
    mesh_.table_.push_back(added);
  }

  /// A little nearer to the surface, so that rounding cannot make it too large.
  Real safe(double distance) const {
    return Real(std::copysign(std::max(std::abs(distance) - slack_, 0.0), distance));
  }

  /// What is left of a brick's triangles: by the balls around them, as that is much faster.
  void divide(const Place& first, int size, const std::vector<Index>& triangles) {
    const Vec3 point = middle(first, size);
    double nearest = std::numeric_limits<double>::infinity(), at_most = nearest;
    for (const Index triangle : triangles) {
      const double distance = (point - balls_[triangle].middle).norm();
      nearest = std::min(nearest, distance - balls_[triangle].radius);
      at_most = std::min(at_most, distance);
    }
    if (nearest - radius(size) >= std::max(reach_, listed_depth * cell_) + slack_)
      return fill(first, size, signed_distance(mesh_.tree_.nearest(point), point));
    std::vector<Index> kept;
    for (const Index triangle : triangles) {
      const Ball& ball = balls_[triangle];
      if ((point - ball.middle).norm() - ball.radius <= at_most + 2.0 * radius(size))
        kept.push_back(triangle);
    }
    if (size == 1) return add_cell(first, kept);
    const int half = size / 2;
    for (int z = 0; z < size; z += half) {
      for (int y = 0; y < size; y += half) {
        for (int x = 0; x < size; x += half) divide(first + Place(x, y, z), half, kept);
      }
    }
  }

  Cell& cell_at(const Place& place) { return cells_of_brick_[number_in_brick(place - first_in_brick_)]; }

  /// Gives cells that are far from the surface what is known of the cube that they are in.
  void fill(const Place& first, int size, double distance) {
    const Vec3 point = middle(first, size);
    for (int z = 0; z < size; ++z) {
      for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
          const Place place = first + Place(x, y, z);
          const double left = std::abs(distance) - (middle(place, 1) - point).norm();
          cell_at(place) = {safe(std::copysign(left, distance)), 0, 0};
        }
      }
    }
  }

  void add_cell(const Place& place, const std::vector<Index>& triangles) {
    const Vec3 point = middle(place, 1);
    std::vector<std::pair<double, Index>> near;
    for (const Index triangle : triangles)
      near.emplace_back((point - surface_[triangle].closest_to(point).point).norm(), triangle);
    const auto [least, nearest] = *std::min_element(near.begin(), near.end());
    const double distance = signed_distance(nearest, point);
    Cell& cell = cell_at(place);
    cell = {safe(distance), Index(mesh_.candidates_.size()), 0};
    if (is_far(distance, 1)) return;
    const double most = least + 2.0 * radius(1);
    std::erase_if(near, [&](const auto& one) { return one.first > most; });
    std::sort(near.begin(), near.end());
    cell.count = Index(near.size());
    for (const auto& [away, triangle] : near) mesh_.candidates_.push_back({safe(away), triangle});
  }

  MeshDistance& mesh_;
  std::vector<SurfaceTriangle<double>> surface_;
  std::vector<Ball> balls_;  ///< around these
  double reach_, cell_ = 0.0, slack_ = 0.0;
  Vec3 low_;
  Cell* cells_of_brick_ = nullptr;  ///< that is filled
  Place first_in_brick_;            ///< of these
};

template <class Real>
MeshDistance<Real>::MeshDistance(const WeldedSurface& surface, double reach)
    : triangles_(surface_triangles<Real>(surface)), tree_(corners_of(surface)) {
  Builder(*this, surface, reach);
  inner_radius_ = Real(0.5 * least_thickness(tree_));
  cells_.shrink_to_fit();
  candidates_.shrink_to_fit();
}

template <class Real>
SeenSurface<Real> MeshDistance<Real>::from(const Vector& point) const {
  const Vector in_cells = (point - low_) * inverse_cell_;
  const Place cells = brick * bricks_;
  if (!((in_cells.array() >= Real(0)).all() &&
        (in_cells.array() < cells.template cast<Real>().array()).all()))
    return outside_grid(point);
  const Place cell = in_cells.template cast<int>();
  const Place place = cell / brick;
  const Brick& home = table_[std::size_t((place[2] * bricks_[1] + place[1]) * bricks_[0] + place[0])];
  if (home.first_cell < 0) return far_from(home.distance, middle(brick * place, brick), point);
  const Cell& own = cells_[std::size_t(home.first_cell) + number_in_brick(cell - brick * place)];
  const Vector centre = middle(cell, 1);
  if (own.count == 0) return far_from(own.distance, centre, point);
  return nearest_of(own, (point - centre).norm(), point);
}

template <class Real>
SeenSurface<Real> MeshDistance<Real>::nearest_of(const Cell& cell, Real from_middle,
                                                 const Vector& point) const {
  Real least = std::numeric_limits<Real>::infinity();
  Index found = 0;
  ClosestOnTriangle<Real> closest{};
  for (Index i = cell.first; i < cell.first + cell.count; ++i) {
    const Candidate& candidate = candidates_[i];
    const Real at_least = candidate.distance - from_middle;
    if (at_least > Real(0) && at_least * at_least >= least) break;
    const ClosestOnTriangle<Real> here = triangles_[candidate.triangle].closest_to(point);
    const Real square = (point - here.point).squaredNorm();
    if (!(square < least)) continue;
    least = square;
    found = candidate.triangle;
    closest = here;
  }
  SeenSurface<Real> seen = triangles_[found].seen_from(closest, point);
  if (closest.part == TrianglePart::face) seen.holds_within = holds_within(cell, from_middle, found, point);
  return seen;
}

/// With d the distance to this face, a plane while the point is above it, and e that to another triangle,
/// which is convex: e - d falls no faster than the difference of their gradients where the point is now.
template <class Real>
Real MeshDistance<Real>::holds_within(const Cell& cell, Real from_middle, Index face,
                                      const Vector& point) const {
  const Real distance = triangles_[face].distance_to_plane(point), height = std::abs(distance);
  const Vector gradient =
      std::copysign(Real(1), distance) * triangles_[face].normals[std::size_t(TrianglePart::face)];
  // What the list leaves out is further than this.
  const Real unlisted = std::abs(cell.distance) + std::sqrt(Real(3)) * cell_ - from_middle;
  Real within = std::min(triangles_[face].distance_to_sides(point), Real(0.5) * (unlisted - height));
  for (Index i = cell.first; i < cell.first + cell.count; ++i) {
    const Candidate& candidate = candidates_[i];
    if (Real(0.5) * (candidate.distance - from_middle - height) >= within) break;
    if (candidate.triangle == face) continue;
    const Vector away = point - triangles_[candidate.triangle].closest_to(point).point;
    const Real length = away.norm(), further = length - height - slack_;
    const Real slope = (away / length - gradient).norm();
    // On the other side of the plane the gradient of d is turned around.
    within = std::min(within, std::min(further / slope, std::max(height, Real(0.5) * further)));
  }
  return std::max(within - slack_, Real(0));
}

template <class Real>
SeenSurface<Real> MeshDistance<Real>::far_from(Real distance, const Vector& middle,
                                               const Vector& point) const {
  return distance > Real(0) ? seen_far_away(distance - (point - middle).norm(), reach_) : by_tree(point);
}

template <class Real>
SeenSurface<Real> MeshDistance<Real>::outside_grid(const Vector& point) const {
  const Vector size = cell_ * Real(brick) * bricks_.template cast<Real>();
  const Vector beyond = (low_ - point).cwiseMax(point - low_ - size);
  return seen_far_away(beyond.maxCoeff() + margin_, reach_);
}

template <class Real>
SeenSurface<Real> MeshDistance<Real>::by_tree(const Vector& point) const {
  const SurfaceTriangle<Real>& nearest = triangles_[tree_.nearest(point.template cast<double>())];
  return nearest.seen_from(nearest.closest_to(point), point);
}

template <class Real>
Real MeshDistance<Real>::exactly(const Vector& point) const {
  return by_tree(point).distance(point);
}

template <class Real>
std::size_t MeshDistance<Real>::bytes() const {
  return table_.capacity() * sizeof(Brick) + cells_.capacity() * sizeof(Cell) +
         candidates_.capacity() * sizeof(Candidate) + triangles_.capacity() * sizeof(SurfaceTriangle<Real>) +
         tree_.bytes();
}

template class MeshDistance<float>;
template class MeshDistance<double>;

}  // namespace hooke
