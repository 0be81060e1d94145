#include "collide/contact_masses.h"

namespace hooke {

void ContactMasses::let_go() {
  for (const Index i : held_) {
    inverse_[i] = free_[i];
    is_pinched_[i] = 0;
  }
  held_.clear();
}

void ContactMasses::hold(Index particle) {
  held_.push_back(particle);
  inverse_[particle] = 0.0;
}

void ContactMasses::pinch(Index particle) {
  hold(particle);
  is_pinched_[particle] = 1;
}

bool ContactMasses::takes_pinched(const SurfaceContact& contact) const {
  for (std::size_t k = 0; k < 4; ++k) {
    if (contact.weights[k] != 0.0 && is_pinched_[contact.particles[k]] != 0) return true;
  }
  return false;
}

}  // namespace hooke
