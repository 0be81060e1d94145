#pragma once

#include <utility>
#include <vector>

#include <hooke/index.h>

#include "collide/contact_sweeps.h"

namespace hooke {

/// What particles weigh for contact in a step: some may not be moved at all, and some for this step only.
class ContactMasses {
 public:
  /// `free`: [1/kg] in the engine's order, 0 of what is never moved.
  explicit ContactMasses(std::vector<double> free)
      : free_(std::move(free)), inverse_(free_), is_pinched_(free_.size(), 0) {}

  /// [1/kg] in the engine's order, 0 of what is not moved.
  const std::vector<double>& inverse() const { return inverse_; }

  bool can_move(Index particle) const { return inverse_[particle] > 0.0; }

  /// At the start of a step nothing is known to be held.
  void let_go();

  /// It is not moved in this step.
  void hold(Index particle);

  /// It is not moved in this step, as colliders leave it no place to go, and takes part in no contact.
  void pinch(Index particle);

  bool takes_pinched(const SurfaceContact& contact) const;

  std::size_t bytes() const {
    return (free_.capacity() + inverse_.capacity()) * sizeof(double) + is_pinched_.capacity() +
           held_.capacity() * sizeof(Index);
  }

 private:
  std::vector<double> free_, inverse_;
  std::vector<unsigned char> is_pinched_;  ///< of each particle in this step
  std::vector<Index> held_;                ///< in this step
};

}  // namespace hooke
