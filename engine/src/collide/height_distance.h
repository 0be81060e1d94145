#pragma once

#include <vector>

#include <hooke/shapes.h>

#include "collide/seen_surface.h"

namespace hooke {

/// Signed distances to a heightfield, walls and bottom included, from any point. The triangles that may be
/// nearest are those around the point's own square, ring by ring.
template <class RealType>
class HeightDistance {
 public:
  using Real = RealType;
  using Vector = Eigen::Matrix<Real, 3, 1>;

  /// Distances below `reach` [m], >= 0, will be exact, inside of course; of what is further out only a bound
  /// from below that is >= reach is told.
  HeightDistance(const HeightfieldShape& field, double reach);

  SeenSurface<Real> from(const Vector& point) const { return from(point, reach_); }

  /// The distance of a point, exact however far it is: takes longer.
  Real exactly(const Vector& point) const {
    return from(point, std::numeric_limits<Real>::infinity()).distance(point);
  }

  Real inner_radius() const { return inner_radius_; }
  std::size_t bytes() const { return heights_.capacity() * sizeof(Real); }

 private:
  struct Nearest {
    Real square;  ///< of the distance
    Vector point, normal;
    bool is_on_face;
    Real second = std::numeric_limits<Real>::infinity();  ///< square of the distance to the second nearest
  };

  SeenSurface<Real> from(const Vector& point, Real reach) const;
  Real height(Index column, Index row) const { return heights_[std::size_t(row) * columns_ + column]; }
  Vector corner(Index column, Index row) const;
  Real height_at(Real x, Real z) const;
  void add(const Nearest& other, Nearest& nearest) const;
  Index square_of(Real from_low, Index points) const;
  void look_at_walls(const Vector& point, bool is_inside, Nearest& nearest) const;
  void look_at_top(const Vector& point, Nearest& nearest) const;
  bool look_at_square(Index column, Index row, const Vector& point, Nearest& nearest) const;
  void look_at_triangle(const Vector& a, const Vector& b, const Vector& c, const Vector& point,
                        Nearest& nearest) const;

  Index columns_, rows_;
  Real spacing_, inverse_spacing_;
  Vector half_;  ///< of the box around it
  Real reach_, inner_radius_;
  Real slack_;   ///< that rounding may make of places in the box [m]
  Real cosine_;  ///< of the steepest slope's angle
  std::vector<Real> heights_;
};

/// The box around a heightfield.
Eigen::AlignedBox3d box_around(const HeightfieldShape& field);

}  // namespace hooke
