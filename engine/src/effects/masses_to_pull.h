#pragma once

#include <vector>

#include <hooke/scene.h>

#include "model/model.h"
#include "model/row_store.h"

namespace hooke {

/// The masses [kg] that forces per mass pull at, in the engine's order. A pinned particle does not fall, and
/// has no energy to give: without mass here it is left alone. One that is attached to a frame weighs upon it.
template <class Real>
BlockRows<Real> masses_to_pull(const Scene& scene, const Model<Real>& model) {
  std::vector<bool> pinned(model.particles(), false);
  for (const Pin& pin : scene.pins) pinned[pin.particle] = true;
  return BlockRows<Real>(model.particles(), [&](std::size_t i) {
    const Index particle = model.order.user(i);
    return pinned[particle] ? Real(0) : Real(scene.particles.mass[particle]);
  });
}

}  // namespace hooke
