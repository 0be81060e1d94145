#pragma once

#include "engine_forces.h"
#include "reference_scenes.h"

namespace hooke::test {

/// Where the engine itself has a scene at its end, in the order of EngineForces' y. It gets there in `steps`
/// steps of the simulation.
std::vector<double> engine_run(const ReferenceScene& scene, const Method& method, std::uint64_t steps);

}  // namespace hooke::test
