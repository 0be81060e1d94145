#pragma once

#include <vector>

#include "bench_scenes.h"
#include "lammps_network.h"
#include "peer.h"

namespace hooke::bench {

/// LAMMPS on one and on two processes, moving the springs alone: no gravity, no drag. Throws
/// std::runtime_error where the engine itself, started alike, does not follow velocity Verlet.
std::vector<Peer> lammps_peers(const LammpsPrograms& programs, const BenchScene& bench);

}  // namespace hooke::bench
