#pragma once

#include <cstddef>
#include <vector>

#include <hooke/scene.h>

namespace hooke {

/// Bounds on what effects hold particles with: stiffness [N/m] and damping [N s/m] such that the derivative
/// of all effects' forces is at most the diagonal matrix of these. An element of n particles with a stiffness
/// matrix of largest eigenvalue s counts s for each of them.
class HeldParticles {
 public:
  explicit HeldParticles(std::size_t particles) : particles_(particles) {}

  /// Every particle is held so.
  void add_to_each(double stiffness, double damping) {
    stiffness_of_each_ += stiffness;
    damping_of_each_ += damping;
  }

  void add(Index particle, double stiffness, double damping) {
    if (own_.empty()) own_.resize(particles_);  // a scene may be large: what it lacks takes no memory
    own_[particle].stiffness += stiffness;
    own_[particle].damping += damping;
  }

  bool any() const { return stiffness_of_each_ + damping_of_each_ > 0.0 || !own_.empty(); }

  double stiffness(std::size_t particle) const {
    return stiffness_of_each_ + (own_.empty() ? 0.0 : own_[particle].stiffness);
  }
  double damping(std::size_t particle) const {
    return damping_of_each_ + (own_.empty() ? 0.0 : own_[particle].damping);
  }

 private:
  struct Held {
    double stiffness = 0.0, damping = 0.0;
  };

  std::size_t particles_;
  double stiffness_of_each_ = 0.0, damping_of_each_ = 0.0;
  std::vector<Held> own_;
};

}  // namespace hooke
