#pragma once

#include <vector>

#include <hooke/scene.h>

#include "model/order.h"

namespace hooke {

/// What corrections of a step may not move.

/// A particle that a script moves from one time to another [s].
struct ScriptedTime {
  Index particle;  ///< in the engine's order
  double from, to;

  bool holds_at(double time) const { return from <= time && time <= to; }
};

std::vector<ScriptedTime> scripted_times(const Scene& scene, const Order& order);

/// In the engine's order [1/kg]; 0 of particles that are pinned or attached to a frame.
std::vector<double> inverse_masses_of_free(const Scene& scene, const Order& order);

/// In the user's numbering those that are pinned, attached to a frame or named in a motion script. Numbers
/// beyond the scene's particles are passed over.
std::vector<bool> fixed_particles(const Scene& scene);

bool has_attachments(const Scene& scene);

}  // namespace hooke
