#pragma once

#include <memory>
#include <vector>

#include <hooke/scene.h>

namespace hooke::bench {

/// How Bullet's soft body is run.
struct BulletSettings {
  int iterations = 10;   ///< projections of every link for a step
  double damping = 0.0;  ///< rate at which velocities decay [1/s]
};

/// A network of springs as a soft body of Bullet: each spring a link, each pinned particle a node of infinite
/// mass, gravity as in the scene, no collisions. A link is a constraint that wants its length at the start;
/// it has no stiffness in N/m, and all have the greatest that Bullet knows.
class BulletCloth {
 public:
  BulletCloth(const Scene& scene, const BulletSettings& settings);
  ~BulletCloth();

  /// One step of `seconds` [s].
  void step(double seconds);

  std::vector<Vec3> positions() const;  ///< [m]

 private:
  struct World;
  std::unique_ptr<World> world_;
  double damping_;
};

}  // namespace hooke::bench
