#pragma once

#include <hooke/methods.h>

#include "forces.h"
#include "model/model.h"
#include "plan.h"

namespace hooke {

/// One Euler step for the blocks [begin, end): forces, velocities and positions in one pass over memory.
/// Where a new value is not finite, the lowest number of such a particle is kept in step.first_bad.
template <class Real>
void euler_blocks(const SymplecticEuler&, const Model<Real>& model, Forces<Real>& forces,
                  const Step<Real>& step, std::size_t begin, std::size_t end);
template <class Real>
void euler_blocks(const ExplicitEuler&, const Model<Real>& model, Forces<Real>& forces,
                  const Step<Real>& step, std::size_t begin, std::size_t end);

}  // namespace hooke
