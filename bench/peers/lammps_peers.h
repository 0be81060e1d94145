#pragma once

#include <vector>

#include "lammps_network.h"
#include "peer.h"

namespace hooke::bench {

/// LAMMPS on one and on two processes, moving the springs of the scene alone: no gravity, no drag. Throws
/// std::runtime_error where the engine itself does not follow velocity Verlet there.
std::vector<Peer> lammps_peers(const reference::LammpsPrograms& programs, const CheckedScene& scene);

}  // namespace hooke::bench
