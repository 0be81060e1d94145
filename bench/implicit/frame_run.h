#pragma once

#include <cstdint>
#include <vector>

#include "implicit/curtain.h"

namespace hooke::bench {

/// Where a method comes to in one frame, and what that costs.
struct FrameRun {
  std::vector<Vec3> positions;  ///< [m]
  Report report;
  double seconds = 0.0;        ///< of the frame, the least of some runs
  double first_seconds = 0.0;  ///< of making the simulation and of its first frame: with what is done once
};

/// Runs a frame on one thread, several times; `Real` is the precision. Throws std::runtime_error where a step
/// goes bad. Iterations that do not suffice are no fault here.
template <class Real>
FrameRun run_frame(const Frame& frame, const Method& method, std::uint64_t steps = 1);

}  // namespace hooke::bench
