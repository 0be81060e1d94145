#pragma once

#include <vector>

#include <hooke/scene.h>

#include "model/order.h"

namespace hooke {

/// A particle that a script moves from one time to another [s].
struct ScriptedTime {
  Index particle;  ///< in the engine's order
  double from, to;

  bool holds_at(double time) const { return from <= time && time <= to; }
};

/// Of all motion scripts of a scene.
std::vector<ScriptedTime> scripted_times(const Scene& scene, const Order& order);

/// [1/kg] in the engine's order, 0 where pinned.
std::vector<double> inverse_masses(const Scene& scene, const Order& order);

}  // namespace hooke
