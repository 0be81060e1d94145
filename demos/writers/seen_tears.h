#pragma once

#include <cstddef>
#include <memory>

#include <hooke/simulation.h>

namespace hooke {

/// Follows a simulation whose scene may tear, by the numbers of its particles and springs: a scene that does
/// not tear costs no more than a look at these.
class SeenTears {
 public:
  /// Whether it has torn, or is whole again, since the last look; the first look sees a whole scene.
  template <class Real>
  bool look_at(const Simulation<Real>& simulation) {
    const bool first = particles_ == 0;
    const bool same = particles_ == simulation.particle_count() && springs_ == simulation.spring_count();
    particles_ = simulation.particle_count();
    springs_ = simulation.spring_count();
    if (first || same) return false;
    scene_ = simulation.snapshot().torn;
    return true;
  }

  /// As it has torn; null where it has not.
  const std::shared_ptr<const Scene>& scene() const { return scene_; }

 private:
  std::size_t particles_ = 0, springs_ = 0;
  std::shared_ptr<const Scene> scene_;
};

}  // namespace hooke
