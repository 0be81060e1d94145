#pragma once

#include <vector>

#include <hooke/effects.h>

namespace hooke::picture {

/// A collider as it is drawn: triangles, with corners anticlockwise from outside, that move as one.
struct Solid {
  std::vector<Vec3> vertices;  ///< [m] from `origin`; sharp edges have those of each side
  std::vector<Triangle> triangles;
  Vec3 origin = Vec3::Zero();  ///< [m] that it turns about
  Vec3 axis = Vec3::UnitY();
  std::vector<RigidKeyframe> path;
};

/// No triangles for a plane, which is drawn as ground.
Solid solid_of(const Collider& collider);

/// Its vertices at a time [s].
std::vector<Vec3> placed(const Solid& solid, double time);

}  // namespace hooke::picture
