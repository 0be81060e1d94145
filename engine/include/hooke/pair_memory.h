#pragma once

#include <array>

#include <hooke/index.h>

namespace hooke {

/// What an effect remembers of two particles, in the user's numbering and the lower number first: a vector of
/// the first against the second, such as where they were when they touched. It turns with them where both are
/// teleported.
template <class Real>
struct PairMemory {
  Index first, second;
  std::array<Real, 3> value;

  bool operator==(const PairMemory&) const = default;
};

}  // namespace hooke
