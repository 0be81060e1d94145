#pragma once

#include "forces.h"
#include "methods/accelerations.h"
#include "model/model.h"

namespace hooke {

/// Writes the accelerations in a state, at its time, to those of one stage.
template <class Real>
void evaluate(const State<Real>& state, const Model<Real>& model, Forces<Real>& forces, Executor& executor,
              Accelerations<Real>& accelerations, std::size_t stage);

}  // namespace hooke
