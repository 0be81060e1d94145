#pragma once

#include <vector>

#include "forces.h"
#include "model/model.h"

namespace hooke {

/// The forces [N] at `time` [s] on the particles that attachments hold, in the order of Frames::held().
template <class Real>
void find_held_forces(const State<Real>& state, double time, const Model<Real>& model, Forces<Real>& forces,
                      Executor& executor, std::vector<Vec3>& found);

}  // namespace hooke
