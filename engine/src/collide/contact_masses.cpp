#include "collide/contact_masses.h"

namespace hooke {

void ContactMasses::let_go(const std::vector<Index>& particles) {
  if (!holds_any_) return;
  holds_any_ = false;
  for (const Index i : particles) {
    inverse_[i] = free_[i];
    is_pinched_[i] = 0;
  }
}

void ContactMasses::hold(Index particle) {
  holds_any_ = true;
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
