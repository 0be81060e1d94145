#pragma once

namespace hooke::viewer {

/// How often a simulation shows its state at most. Where that takes long it is done less often, so that it
/// costs the simulation little.
struct Rhythm {
  double publish_every = 1.0 / 60.0;  ///< [s] of wall time, > 0
  double measure_every = 0.1;         ///< [s] energy and strain, > 0
};

}  // namespace hooke::viewer
