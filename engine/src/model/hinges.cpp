#include "model/hinges.h"

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "scene/mesh_edges.h"

namespace hooke {
namespace {

/// Whether a side, and the height over the edge that belongs to it, span a triangle.
bool has_area(const Vec3& side, const Vec3& height) {
  constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
  return height.squaredNorm() > rounding * rounding * side.squaredNorm();
}

}  // namespace

HingeAngle hinge_angle(const HingeCorners& corners) {
  const Vec3 edge = corners[1] - corners[0], side = corners[2] - corners[0], other = corners[3] - corners[0];
  const double length = edge.norm();
  if (!(length > 0.0)) return {};
  // The heights of both triangles over the edge, turned about it by a right angle: their normals.
  const Vec3 along = edge / length, normal = along.cross(side), other_normal = other.cross(along);
  if (!has_area(side, normal) || !has_area(other, other_normal)) return {};
  HingeAngle hinge;
  hinge.angle = std::atan2(-side.dot(other_normal), normal.dot(other_normal));
  auto& gradient = hinge.gradient;
  gradient[2] = -normal / normal.squaredNorm();
  gradient[3] = -other_normal / other_normal.squaredNorm();
  gradient[1] = -(along.dot(side) * gradient[2] + along.dot(other) * gradient[3]) / length;
  gradient[0] = -(gradient[1] + gradient[2] + gradient[3]);
  return hinge;
}

std::vector<Hinge> hinges_of(const Scene& scene, const std::vector<Triangle>& triangles) {
  const std::vector<Side> sides = sides_of(triangles);
  std::vector<Hinge> hinges;
  for (auto side = sides.begin(); side != sides.end(); ++side) {
    const auto [low, high, corner] = *side;
    for (auto other = side + 1; other != sides.end() && (*other)[0] == low && (*other)[1] == high; ++other) {
      Hinge hinge{{low, high, corner, (*other)[2]}, 0.0};
      const HingeCorners at = corners_of(hinge, scene);
      const Vec3 edge = at[1] - at[0];
      const double areas =
          0.5 * (edge.cross(Vec3(at[2] - at[0])).norm() + edge.cross(Vec3(at[3] - at[0])).norm());
      if (!(areas > 0.0)) continue;
      hinge.stretch = edge.squaredNorm() / areas;
      hinges.push_back(hinge);
    }
  }
  return hinges;
}

HingeCorners corners_of(const Hinge& hinge, const Scene& scene) {
  HingeCorners corners;
  for (std::size_t c = 0; c < corners.size(); ++c) corners[c] = scene.particles.position[hinge.particles[c]];
  return corners;
}

}  // namespace hooke
