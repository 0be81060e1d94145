#pragma once

#include <optional>

#include <hooke/scene.h>
#include <hooke/simulation.h>

namespace hooke::viewer {

/// Up to which step a method is sure to be stable on a scene.
struct StepLimit {
  double step = 0.0;  ///< [s]; 0: none is, as the method lets every undamped oscillation grow
};

/// Whether a method has error control, so that its steps are not the settings'.
bool chooses_steps(const Method& method);

/// Nothing where there is no limit to speak of: the method chooses its steps, or nothing in the scene pulls.
/// It is the bound of hooke/stability.h.
std::optional<StepLimit> step_limit(const Scene& scene, const Method& method);

}  // namespace hooke::viewer
