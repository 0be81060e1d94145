#pragma once

#include <atomic>

#include <hooke/methods.h>

#include "forces.h"
#include "model/model.h"
#include "state.h"

namespace hooke {

/// One Euler step of `h` [s] for the blocks [begin, end): forces, velocities and positions in one pass over
/// memory, from `now` to `next`. Where a new value is not finite, the lowest number of such a particle is
/// kept in `first_bad`.
template <class Real>
void euler_blocks(const SymplecticEuler&, const Model<Real>& model, Forces<Real>& forces,
                  const State<Real>& now, double h, std::size_t begin, std::size_t end, State<Real>& next,
                  std::atomic<Index>& first_bad);
template <class Real>
void euler_blocks(const ExplicitEuler&, const Model<Real>& model, Forces<Real>& forces,
                  const State<Real>& now, double h, std::size_t begin, std::size_t end, State<Real>& next,
                  std::atomic<Index>& first_bad);

}  // namespace hooke
