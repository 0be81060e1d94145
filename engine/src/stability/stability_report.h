#pragma once

#include <vector>

#include <hooke/simulation.h>

#include "effects/effect_list.h"
#include "model/model.h"
#include "stability/step_division.h"

namespace hooke {

/// What a simulation keeps of its scene to say how stable it is.
struct StabilityParts {
  StepBounds bounds;
  std::vector<GroundPlane> grounds;

  StabilityParts(const Scene& scene, const StepBounds& bounds);
};

/// Simulation::stability() in a state.
template <class Real>
Stability report_stability(const StabilityParts& parts, const Settings& settings, const Model<Real>& model,
                           EffectList<Real>& effects, const State<Real>& state, Executor& executor);

}  // namespace hooke
