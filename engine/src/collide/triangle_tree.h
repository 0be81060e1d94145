#pragma once

#include <array>
#include <vector>

#include <Eigen/Geometry>

#include <hooke/index.h>
#include <hooke/vec3.h>

namespace hooke {

/// The places of a triangle's corners [m].
using TriangleCorners = std::array<Vec3, 3>;

/// A tree of boxes around at least one triangle, halved at the middle along the longest side. The same
/// triangles give the same tree.
class TriangleTree {
 public:
  explicit TriangleTree(std::vector<TriangleCorners> triangles);

  const std::vector<TriangleCorners>& triangles() const { return triangles_; }

  /// The triangle that is nearest to a point, the lowest number of those that are equally near.
  Index nearest(const Vec3& point) const;

  /// How far along a unit vector from a point the first triangle is that is passed from its back to its
  /// front, the others left out [m]; infinite where there is none.
  double way_out(const Vec3& point, const Vec3& direction) const;

  /// The triangles within a distance [m] of a point, in the order of their numbers.
  std::vector<Index> within(const Vec3& point, double distance) const;

  /// The triangles whose boxes meet the box of this one, in the order of their numbers.
  std::vector<Index> near_box_of(Index triangle) const;

  std::size_t bytes() const;

 private:
  /// Its triangles are numbers_[begin] to numbers_[end - 1]. An inner node's children are `child` and the one
  /// after.
  struct Node {
    Eigen::AlignedBox3d box;
    Index begin, end;
    Index child;  ///< 0: none
  };

  Eigen::AlignedBox3d box_of(Index triangle) const;
  /// Triangles that match, looking where a box may hold such.
  template <class MayHold, class Matches>
  std::vector<Index> find(const MayHold& may_hold, const Matches& matches) const;
  void divide(Index node);

  std::vector<TriangleCorners> triangles_;
  std::vector<Index> numbers_;
  std::vector<Node> nodes_;
};

}  // namespace hooke
