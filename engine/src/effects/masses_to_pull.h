#pragma once

#include <hooke/scene.h>

#include "model/model.h"
#include "model/row_store.h"

namespace hooke {

/// The masses [kg] that forces per mass pull at, in the engine's order. A pinned particle does not fall, and
/// has no energy to give: without mass here it is left alone.
template <class Real>
BlockRows<Real> masses_to_pull(const Scene& scene, const Model<Real>& model) {
  return BlockRows<Real>(model.particles(), [&](std::size_t i) {
    return model.pinned(i) ? Real(0) : Real(scene.particles.mass[model.order.user(i)]);
  });
}

}  // namespace hooke
