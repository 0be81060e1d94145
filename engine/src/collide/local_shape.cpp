#include "collide/local_shape.h"

#include <limits>

#include <Eigen/Geometry>

namespace hooke {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Vec3 half_length_of(const CapsuleShape& capsule) {
  return 0.5 * (capsule.end - capsule.start);
}

template <class Distances>
LookedUpShape<Distances> looked_up(std::shared_ptr<const Distances> distances, std::size_t blocks) {
  using Seen = AlignedVector<SeenPlanes<typename Distances::Real>>;
  return {std::move(distances), std::make_shared<Seen>(blocks)};
}

template <class Distances>
std::size_t bytes_of(const LookedUpShape<Distances>& shape) {
  return shape.distances->bytes() + shape.seen->size() * sizeof(SeenPlanes<typename Distances::Real>);
}

}  // namespace

template <class Real>
LocalPlane<Real>::LocalPlane(const PlaneShape& plane) : height(Real(plane.height)) {
  const Vec3 normal = plane.normal.stableNormalized();
  nx = Real(normal.x()), ny = Real(normal.y()), nz = Real(normal.z());
}

template <class Real>
LocalCapsule<Real>::LocalCapsule(const CapsuleShape& capsule) : radius(Real(capsule.radius)) {
  const Vec3 half = half_length_of(capsule);
  ex = Real(half.x()), ey = Real(half.y()), ez = Real(half.z());
  const double square = half.squaredNorm();
  inverse_square = square > 0.0 ? Real(1.0 / square) : Real(0);
  const Vec3 aside = square > 0.0 ? Vec3(half.unitOrthogonal()) : Vec3(0.0, 1.0, 0.0);
  aside_x = Real(aside.x()), aside_y = Real(aside.y()), aside_z = Real(aside.z());
}

template <class Real>
LocalShape<Real> local_shape(const ColliderShape& shape, double reach, std::size_t blocks,
                             PreparedMeshes& meshes) {
  if (const auto* plane = std::get_if<PlaneShape>(&shape)) return LocalPlane<Real>(*plane);
  if (const auto* sphere = std::get_if<SphereShape>(&shape)) return LocalSphere<Real>(*sphere);
  if (const auto* capsule = std::get_if<CapsuleShape>(&shape)) return LocalCapsule<Real>(*capsule);
  if (const auto* box = std::get_if<BoxShape>(&shape)) return LocalBox<Real>(*box);
  if (const auto* mesh = std::get_if<MeshShape>(&shape))
    return looked_up(meshes.distances<Real>(*mesh, reach), blocks);
  const auto& field = std::get<HeightfieldShape>(shape);
  return looked_up(std::make_shared<const HeightDistance<Real>>(field, reach), blocks);
}

template LocalShape<float> local_shape(const ColliderShape&, double, std::size_t, PreparedMeshes&);
template LocalShape<double> local_shape(const ColliderShape&, double, std::size_t, PreparedMeshes&);

template <class Real>
std::size_t bytes_of(const LocalShape<Real>& shape) {
  if (const auto* mesh = std::get_if<LookedUpShape<MeshDistance<Real>>>(&shape))
    return bytes_of<MeshDistance<Real>>(*mesh);
  if (const auto* field = std::get_if<LookedUpShape<HeightDistance<Real>>>(&shape))
    return bytes_of<HeightDistance<Real>>(*field);
  return 0;
}

template std::size_t bytes_of(const LocalShape<float>&);
template std::size_t bytes_of(const LocalShape<double>&);

Vec3 origin_of(const ColliderShape& shape) {
  if (const auto* sphere = std::get_if<SphereShape>(&shape)) return sphere->centre;
  if (const auto* capsule = std::get_if<CapsuleShape>(&shape)) return 0.5 * (capsule->start + capsule->end);
  if (const auto* box = std::get_if<BoxShape>(&shape)) return box->centre;
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) return box_around(*mesh).center();
  if (const auto* field = std::get_if<HeightfieldShape>(&shape)) return box_around(*field).center();
  return Vec3::Zero();
}

Vec3 half_extent_of(const ColliderShape& shape) {
  if (const auto* sphere = std::get_if<SphereShape>(&shape)) return Vec3::Constant(sphere->radius);
  if (const auto* capsule = std::get_if<CapsuleShape>(&shape))
    return half_length_of(*capsule).cwiseAbs() + Vec3::Constant(capsule->radius);
  if (const auto* box = std::get_if<BoxShape>(&shape)) return box->half_size;
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) return 0.5 * box_around(*mesh).sizes();
  if (const auto* field = std::get_if<HeightfieldShape>(&shape)) return 0.5 * box_around(*field).sizes();
  return Vec3::Constant(infinite);
}

double radius_of(const ColliderShape& shape) {
  if (const auto* sphere = std::get_if<SphereShape>(&shape)) return sphere->radius;
  if (const auto* capsule = std::get_if<CapsuleShape>(&shape))
    return half_length_of(*capsule).norm() + capsule->radius;
  return half_extent_of(shape).norm();
}

}  // namespace hooke
