#pragma once

#include <memory>
#include <vector>

#include <hooke/scene.h>

namespace hooke::bench {

/// How Bullet's soft body is run.
struct BulletSettings {
  int iterations = 10;            ///< projections of every link for a step
  double damping = 0.0;           ///< rate at which velocities decay [1/s]
  std::vector<double> stiffness;  ///< of each link, in (0, 1]: the share of a link's error that a projection
                                  ///< takes away, its order and its neighbours' aside
};

/// A network of springs as a soft body of Bullet: each spring a link, each pinned particle a node of infinite
/// mass, gravity as in the scene, no collisions. A link is a constraint that wants its length at the start;
/// it has no stiffness in N/m.
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
