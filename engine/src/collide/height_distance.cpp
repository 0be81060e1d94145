#include "collide/height_distance.h"

#include <algorithm>
#include <cmath>

#include "collide/closest_on_triangle.h"

namespace hooke {
namespace {

/// The steepest rise for each metre of the field's triangles.
double steepest(const HeightfieldShape& field) {
  double square = 0.0;
  const auto height = [&](Index i, Index j) { return field.heights[std::size_t(j) * field.columns + i]; };
  for (Index j = 0; j + 1 < field.rows; ++j) {
    for (Index i = 0; i + 1 < field.columns; ++i) {
      const double a = height(i, j), b = height(i + 1, j), c = height(i + 1, j + 1), d = height(i, j + 1);
      square = std::max(
          {square, std::pow(b - a, 2) + std::pow(c - b, 2), std::pow(d - a, 2) + std::pow(c - d, 2)});
    }
  }
  return std::sqrt(square) / field.spacing;
}

}  // namespace

Eigen::AlignedBox3d box_around(const HeightfieldShape& field) {
  const auto [lowest, highest] = std::minmax_element(field.heights.begin(), field.heights.end());
  const Vec3 far(field.spacing * (field.columns - 1.0), *highest, field.spacing * (field.rows - 1.0));
  return {field.corner + Vec3(0.0, *lowest - field.depth, 0.0), field.corner + far};
}

template <class Real>
HeightDistance<Real>::HeightDistance(const HeightfieldShape& field, double reach)
    : columns_(field.columns),
      rows_(field.rows),
      spacing_(Real(field.spacing)),
      inverse_spacing_(Real(1.0 / field.spacing)),
      half_((0.5 * box_around(field).sizes()).cast<Real>()),
      reach_(Real(reach)),
      inner_radius_(Real(0.5 * std::min(field.spacing, field.depth))),
      slack_(Real(16) * std::numeric_limits<Real>::epsilon() * half_.maxCoeff()),
      cosine_(Real(1.0 / std::hypot(1.0, steepest(field)))) {
  const double middle = box_around(field).center().y() - field.corner.y();
  heights_.reserve(field.heights.size());
  for (const double height : field.heights) heights_.push_back(Real(height - middle));
}

template <class Real>
typename HeightDistance<Real>::Vector HeightDistance<Real>::corner(Index column, Index row) const {
  return {Real(column) * spacing_ - half_.x(), height(column, row), Real(row) * spacing_ - half_.z()};
}

/// The square that a point lies in, or the last one.
template <class Real>
Index HeightDistance<Real>::square_of(Real from_low, Index points) const {
  const Real place = from_low * inverse_spacing_;
  return place > Real(0) ? std::min(Index(std::min(place, Real(points))), points - 2) : 0;
}

/// Of a place within the sides.
template <class Real>
Real HeightDistance<Real>::height_at(Real x, Real z) const {
  const Index i = square_of(x + half_.x(), columns_), j = square_of(z + half_.z(), rows_);
  const Real u = (x + half_.x()) * inverse_spacing_ - Real(i),
             w = (z + half_.z()) * inverse_spacing_ - Real(j);
  const Real low = height(i, j), high = height(i + 1, j + 1);
  const Real beside = u >= w ? height(i + 1, j) : height(i, j + 1);
  const Real first = std::max(u, w), second = std::min(u, w);
  return low + first * (beside - low) + second * (high - beside);
}

template <class Real>
SeenSurface<Real> HeightDistance<Real>::from(const Vector& point, Real reach) const {
  const Real x = std::clamp(point.x(), -half_.x(), half_.x()),
             z = std::clamp(point.z(), -half_.z(), half_.z());
  if (!point.allFinite()) return seen_far_away(std::numeric_limits<Real>::quiet_NaN(), Real(0));
  const Real top = height_at(x, z);
  const bool is_beside = x != point.x() || z != point.z();
  if (point.y() <= top && (is_beside || point.y() < -half_.y())) {
    const Vector nearest(x, std::max(point.y(), -half_.y()), z);
    const Real distance = (point - nearest).norm();
    if (distance > reach + slack_) return seen_far_away(distance, reach);
    // Straight off a wall: with the bits that it has from inside.
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const Vector straight = Vector::Unit(axis) * (point[axis] - nearest[axis]);
      if (straight == point - nearest && !straight.isZero(0))
        return {std::copysign(Real(1), point[axis]) * Vector::Unit(axis), half_[axis], Real(0)};
    }
    return seen_from_edge<Real>(nearest, Vector(-Vector::UnitY()), Real(1), point);
  }
  const Real above = (point.y() - top) * cosine_ - slack_;
  if (above > reach) return seen_far_away(above, reach);
  Nearest nearest{std::numeric_limits<Real>::infinity(), Vector::Zero(), Vector::UnitY(), true};
  const bool is_inside = point.y() < top;
  look_at_walls(point, is_inside, nearest);
  look_at_top(point, nearest);
  if (!nearest.is_on_face)
    return seen_from_edge<Real>(nearest.point, nearest.normal, is_inside ? Real(-1) : Real(1), point);
  // Neither distance changes by more than the point moves.
  const Real further = std::sqrt(nearest.second) - std::sqrt(nearest.square);
  return {nearest.normal, nearest.normal.dot(nearest.point), std::max(Real(0.5) * further - slack_, Real(0))};
}

/// Keeps the nearer one.
template <class Real>
void HeightDistance<Real>::add(const Nearest& other, Nearest& nearest) const {
  if (!(other.square < nearest.square)) {
    nearest.second = std::min(nearest.second, other.square);
    return;
  }
  const Real second = std::min(nearest.second, nearest.square);
  nearest = other;
  nearest.second = second;
}

/// The walls and the bottom are the nearest only to what is inside; to what is above the top they are at
/// least as far as their planes.
template <class Real>
void HeightDistance<Real>::look_at_walls(const Vector& point, bool is_inside, Nearest& nearest) const {
  const auto look = [&](Eigen::Index axis, Real side) {
    const Real away = side * half_[axis] - point[axis];
    if (is_inside)
      add({away * away, side * half_[axis] * Vector::Unit(axis), side * Vector::Unit(axis), true}, nearest);
    else
      nearest.second = std::min(nearest.second, away * away);
  };
  look(0, Real(-1)), look(0, Real(1));
  look(1, Real(-1));
  look(2, Real(-1)), look(2, Real(1));
}

template <class Real>
void HeightDistance<Real>::look_at_top(const Vector& point, Nearest& nearest) const {
  const auto column = std::int64_t(square_of(point.x() + half_.x(), columns_));
  const auto row = std::int64_t(square_of(point.z() + half_.z(), rows_));
  const auto look = [&](std::int64_t i, std::int64_t j) {
    if (i < 0 || j < 0 || i + 1 >= std::int64_t(columns_) || j + 1 >= std::int64_t(rows_)) return false;
    return look_at_square(Index(i), Index(j), point, nearest);
  };
  bool may_be_nearer = look(column, row);
  for (std::int64_t ring = 1; may_be_nearer; ++ring) {
    may_be_nearer = false;
    for (std::int64_t i = -ring; i <= ring; ++i) {
      may_be_nearer |= look(column + i, row - ring);
      may_be_nearer |= look(column + i, row + ring);
    }
    for (std::int64_t j = 1 - ring; j < ring; ++j) {
      may_be_nearer |= look(column - ring, row + j);
      may_be_nearer |= look(column + ring, row + j);
    }
  }
}

/// Whether it was near enough, in the plane of x and z, to be looked at.
template <class Real>
bool HeightDistance<Real>::look_at_square(Index column, Index row, const Vector& point,
                                          Nearest& nearest) const {
  const Vector low = corner(column, row), high = corner(column + 1, row + 1);
  const Real x = point.x() - std::clamp(point.x(), low.x(), high.x());
  const Real z = point.z() - std::clamp(point.z(), low.z(), high.z());
  if (!(x * x + z * z < std::max(nearest.square, nearest.second))) return false;
  look_at_triangle(low, high, corner(column + 1, row), point, nearest);
  look_at_triangle(low, corner(column, row + 1), high, point, nearest);
  return true;
}

template <class Real>
void HeightDistance<Real>::look_at_triangle(const Vector& a, const Vector& b, const Vector& c,
                                            const Vector& point, Nearest& nearest) const {
  const ClosestOnTriangle<Real> closest = closest_on_triangle<Real>(point, a, b, c);
  const bool is_on_face = closest.part == TrianglePart::face;
  // Of a face any point tells the plane; a corner's does so with the same bits wherever it is seen from.
  add({(point - closest.point).squaredNorm(), is_on_face ? a : closest.point,
       (b - a).cross(c - a).normalized(), is_on_face},
      nearest);
}

template class HeightDistance<float>;
template class HeightDistance<double>;

}  // namespace hooke
