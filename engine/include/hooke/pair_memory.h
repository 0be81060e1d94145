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

/// Whether one pair of particles comes before another one: by their first particles, then by their second
/// ones. What is remembered of pairs is sorted so.
struct PairOrder {
  template <class Pair, class Other>
  bool operator()(const Pair& pair, const Other& other) const {
    return pair.first != other.first ? pair.first < other.first : pair.second < other.second;
  }
};

}  // namespace hooke
