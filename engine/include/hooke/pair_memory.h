#pragma once

#include <array>

#include <hooke/index.h>

namespace hooke {

/// What an effect remembers of two particles, such as how far they have slid along each other.
template <class Real>
struct PairMemory {
  Index first, second;
  std::array<Real, 3> value;

  bool operator==(const PairMemory&) const = default;
};

}  // namespace hooke
