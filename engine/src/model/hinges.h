#pragma once

#include <array>
#include <vector>

#include <hooke/scene.h>

namespace hooke {

/// The corners of two triangles with an edge in common: the ends of the edge, then the corner opposite in
/// each triangle. Which of these comes first matters nothing: it turns the sign of every angle.
using HingeCorners = std::array<Vec3, 4>;

/// The angle between the two triangles' normals, and how fast it grows as each corner moves (Bridson, Marino,
/// Fedkiw 2003). Where a triangle has no area, but for rounding, all is zero.
struct HingeAngle {
  double angle = 0.0;  ///< theta [rad], from -pi to pi; 0 where both lie in one plane, side by side
  std::array<Vec3, 4> gradient{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< [1/m]
};

HingeAngle hinge_angle(const HingeCorners& corners);

/// Two of a scene's triangles with an edge in common.
struct Hinge {
  std::array<Index, 4> particles;  ///< as in HingeCorners
  double stretch;                  ///< |e|^2 / (A1 + A2) at the start [1]
};

/// The hinges of some of a scene's triangles, in the order of their edges. An edge of more than two triangles
/// makes one for each pair. Two triangles without area make none.
std::vector<Hinge> hinges_of(const Scene& scene, const std::vector<Triangle>& triangles);

/// The corners of a hinge at the start.
HingeCorners corners_of(const Hinge& hinge, const Scene& scene);

}  // namespace hooke
