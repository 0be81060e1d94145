#pragma once

#include <vector>

#include <hooke/scene.h>

#include "collide/local_shape.h"
#include "frames/frames.h"

namespace hooke {

/// A collider as seen from a place.
struct ObstacleSurface {
  double gap;     ///< to its surface and thickness [m]
  Vec3 outwards;  ///< unit vector
  Vec3 velocity;  ///< of the surface [m/s]
  double friction;
};

/// The colliders of a scene that particles are put back on, one place at a time: for what has to know how
/// particles lie on them.
class Obstacles {
 public:
  /// They are seen from places nearer than `margin` [m] to their surface and thickness. Where the scene has a
  /// collider it has frames.
  Obstacles(const Scene& scene, const Frames* frames, PreparedMeshes& meshes, double margin);

  std::size_t size() const { return solids_.size(); }

  /// They are looked at as at `time` [s], the end of a step of `h` [s].
  void move_to(double time, double h);

  ObstacleSurface seen_from(const Vec3& place, std::size_t obstacle) const;

  std::size_t bytes() const;

 private:
  struct Solid {
    const RigidMotion* motion;
    LocalShape<double> shape;
    double thickness, friction;
    Vec3 origin, velocity, spin;  ///< in the world
    Eigen::Matrix3d rotation;
  };

  std::vector<Solid> solids_;
};

}  // namespace hooke
