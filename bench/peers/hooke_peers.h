#pragma once

#include <memory>
#include <vector>

#include "checked_scene.h"
#include "peer.h"

namespace hooke::bench {

/// The engine with its default accumulation, in float and double, on one thread and on all.
std::vector<Peer> hooke_peers(const std::shared_ptr<const CheckedScene>& scene);

/// All positions [m] in the user's numbering.
template <class Real>
std::vector<Vec3> positions_of(const Simulation<Real>& simulation) {
  std::vector<Vec3> positions(simulation.particle_count());
  simulation.copy_positions(positions[0].data(), sizeof(Vec3));
  return positions;
}

}  // namespace hooke::bench
