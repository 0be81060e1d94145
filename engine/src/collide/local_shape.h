#pragma once

#include <algorithm>
#include <memory>
#include <variant>

#include <Eigen/Core>

#include <hooke/shapes.h>

#include "collide/height_distance.h"
#include "collide/mesh_distance.h"
#include "collide/prepared_meshes.h"
#include "collide/seen_planes.h"

namespace hooke {

/// The shapes in the precision of the run and in their own frame: its origin is what they turn about, the
/// centre of a solid and for a plane the world's origin at the start.

template <class Real>
struct LocalPlane {
  explicit LocalPlane(const PlaneShape& plane);
  static constexpr bool can_be_passed = false;  ///< within a step, by a particle outside before and after

  Real nx, ny, nz, height;
};

template <class Real>
struct LocalSphere {
  explicit LocalSphere(const SphereShape& sphere) : radius(Real(sphere.radius)) {}
  static constexpr bool can_be_passed = true, is_looked_up = false;
  Real inner_radius() const { return radius; }  ///< of the largest ball in it [m]

  Real radius;
};

template <class Real>
struct LocalCapsule {
  explicit LocalCapsule(const CapsuleShape& capsule);
  static constexpr bool can_be_passed = true, is_looked_up = false;
  Real inner_radius() const { return radius; }

  Real ex, ey, ez;                 ///< from the middle to the end
  Real inverse_square;             ///< of that; 0 where both ends are one
  Real aside_x, aside_y, aside_z;  ///< the normal of its points inside that have none: a unit vector across
  Real radius;
};

template <class Real>
struct LocalBox {
  explicit LocalBox(const BoxShape& box)
      : hx(Real(box.half_size.x())), hy(Real(box.half_size.y())), hz(Real(box.half_size.z())) {}
  static constexpr bool can_be_passed = true, is_looked_up = false;
  Real inner_radius() const { return std::min({hx, hy, hz}); }

  Real hx, hy, hz;
};

/// A shape whose distances are looked up.
template <class Distances>
struct LookedUpShape {
  static constexpr bool can_be_passed = true, is_looked_up = true;
  auto inner_radius() const { return distances->inner_radius(); }

  std::shared_ptr<const Distances> distances;
  std::shared_ptr<AlignedVector<SeenPlanes<typename Distances::Real>>> seen;  ///< by each block of particles
};

template <class Real>
using LocalShape = std::variant<LocalPlane<Real>, LocalSphere<Real>, LocalCapsule<Real>, LocalBox<Real>,
                                LookedUpShape<MeshDistance<Real>>, LookedUpShape<HeightDistance<Real>>>;

/// For so many blocks of particles. Distances from the shape will be exact where they are below `reach` [m],
/// >= 0. A mesh's are from `meshes`.
template <class Real>
LocalShape<Real> local_shape(const ColliderShape& shape, double reach, std::size_t blocks,
                             PreparedMeshes& meshes);

/// What it holds beside itself.
template <class Real>
std::size_t bytes_of(const LocalShape<Real>& shape);

/// Half of the extent along the world's axes [m], around origin_of(), of a shape that is not turned; infinite
/// for a plane.
Vec3 half_extent_of(const ColliderShape& shape);

/// The radius [m] around origin_of() within which a shape lies however it is turned; infinite for a plane.
double radius_of(const ColliderShape& shape);

}  // namespace hooke
