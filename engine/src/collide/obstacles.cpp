#include "collide/obstacles.h"

#include <hwy/highway.h>

#include "collide/shapes-inl.h"
#include "collide/solid_bounds.h"

namespace hooke {

Obstacles::Obstacles(const Scene& scene, const Frames* frames, PreparedMeshes& meshes, double margin) {
  for (std::size_t i = 0; i < scene.effects.size(); ++i) {
    const auto* const collider = std::get_if<Collider>(&scene.effects[i]);
    if (collider == nullptr || is_penalty(*collider)) continue;
    solids_.push_back({frames->of(i),
                       local_shape<double>(collider->shape, collider->thickness + margin, 0, meshes),
                       collider->thickness, collider->friction, Vec3::Zero(), Vec3::Zero(), Vec3::Zero(),
                       Eigen::Matrix3d::Identity()});
  }
}

void Obstacles::move_to(double time, double h) {
  for (Solid& solid : solids_) {
    solid.origin = solid.motion->origin(time);
    solid.rotation = solid.motion->rotation(time);
    solid.velocity = (solid.origin - solid.motion->origin(time - h)) / h;
    solid.spin = solid.rotation * solid.motion->turn(time - h, time) / h;
  }
}

ObstacleSurface Obstacles::seen_from(const Vec3& place, std::size_t obstacle) const {
  namespace simd = HWY_NAMESPACE;
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::CappedTag<double, 1> d;
  using V = hn::Vec<decltype(d)>;
  const Solid& solid = solids_[obstacle];
  const Vec3 local = solid.rotation.transpose() * (place - solid.origin);
  const simd::Vector3<V> p{hn::Set(d, local.x()), hn::Set(d, local.y()), hn::Set(d, local.z())};
  const simd::Surface<V> surface =
      std::visit([&](const auto& shape) { return simd::surface_at(d, shape, p); }, solid.shape);
  const Vec3 outwards(hn::GetLane(surface.outwards.x), hn::GetLane(surface.outwards.y),
                      hn::GetLane(surface.outwards.z));
  return {hn::GetLane(surface.distance) - solid.thickness, solid.rotation * outwards,
          solid.velocity + solid.spin.cross(place - solid.origin), solid.friction};
}

std::size_t Obstacles::bytes() const {
  std::size_t bytes = solids_.capacity() * sizeof(Solid);
  for (const Solid& solid : solids_) bytes += bytes_of(solid.shape);
  return bytes;
}

}  // namespace hooke
