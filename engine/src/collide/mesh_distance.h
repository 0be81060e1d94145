#pragma once

#include <cstdint>
#include <vector>

#include "collide/mesh_surface.h"

namespace hooke {

/// Signed distances to a closed mesh from any point. A sparse grid: bricks of 8 x 8 x 8 cells where the
/// surface is near, a number elsewhere. A cell near the surface lists the triangles that can be the nearest
/// one to a point in it, so distances there are exact; so are those deeper inside, by a tree.
template <class RealType>
class MeshDistance {
 public:
  using Real = RealType;
  using Vector = Eigen::Matrix<Real, 3, 1>;

  /// Distances below `reach` [m], >= 0, will be exact, inside of course; of what is further out only a bound
  /// from below that is >= reach is told.
  MeshDistance(const WeldedSurface& surface, double reach);

  SeenSurface<Real> from(const Vector& point) const;

  /// The distance of a point, exact however far it is: takes longer.
  Real exactly(const Vector& point) const;

  Real inner_radius() const { return inner_radius_; }  ///< half of the solid's least thickness [m]
  std::size_t bytes() const;

 private:
  using Place = Eigen::Vector3i;   ///< counted along x, y and z
  static constexpr int brick = 8;  ///< cells along a side
  static constexpr int brick_cells = brick * brick * brick;

  struct Cell {
    Real distance;       ///< a bound on that of its middle: that is at least so far on its side
    Index first, count;  ///< of its candidates; none where it is far from the surface
  };
  struct Candidate {
    Real distance;  ///< from the middle of the cell
    Index triangle;
  };
  struct Brick {
    Real distance;            ///< like a cell's, of its middle
    std::int32_t first_cell;  ///< none: -1
  };
  class Builder;

  static std::size_t number_in_brick(const Place& cell) {
    return std::size_t((cell[2] * brick + cell[1]) * brick + cell[0]);
  }
  /// The middle of a cube of cells whose lowest one is this.
  Vector middle(const Place& first, int size) const {
    return low_ + cell_ * (first.template cast<Real>() + Vector::Constant(Real(0.5) * Real(size)));
  }
  SeenSurface<Real> nearest_of(const Cell& cell, Real from_middle, const Vector& point) const;
  Real holds_within(const Cell& cell, Real from_middle, Index face, const Vector& point) const;
  SeenSurface<Real> by_tree(const Vector& point) const;
  SeenSurface<Real> far_from(Real distance, const Vector& middle, const Vector& point) const;
  SeenSurface<Real> outside_grid(const Vector& point) const;

  Vector low_;                ///< corner of the grid [m]
  Real margin_;               ///< of the grid around the mesh [m], more than `reach_`
  Real reach_;                ///< [m]
  Real slack_;                ///< that rounding may make of places in the grid [m]
  Real cell_, inverse_cell_;  ///< its sides [m]
  Real inner_radius_;
  Place bricks_;  ///< along x, y and z
  std::vector<Brick> table_;
  std::vector<Cell> cells_;
  std::vector<Candidate> candidates_;  ///< of each cell the nearest first
  std::vector<SurfaceTriangle<Real>> triangles_;
  TriangleTree tree_;
};

}  // namespace hooke
