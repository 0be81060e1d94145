#pragma once

#include <memory>
#include <vector>

#include "tearing/strained_springs.h"

namespace hooke {

/// What a simulation of a scene that may tear keeps of it.
template <class Real>
struct Tears {
  std::shared_ptr<const Scene> start;  ///< as it was given
  std::shared_ptr<const Scene> now;    ///< as it has torn; the same one where it has not
  std::vector<Index> torn_from;        ///< of each particle that was added, the one of `start`
  UnstableStep unstable_step;          ///< as it was given
  StrainedSprings<Real> springs;       ///< of `now`

  bool torn() const { return now != start; }
};

}  // namespace hooke
