#pragma once

#include <numeric>
#include <vector>

#include <hooke/index.h>

namespace hooke {

/// Things that are joined two by two, and so fall into parts (union-find; Tarjan 1975).
class JoinedParts {
 public:
  explicit JoinedParts(std::size_t count) : towards_(count) {
    std::iota(towards_.begin(), towards_.end(), Index{0});
  }

  /// The lowest of its part.
  Index lowest(Index one) {
    while (towards_[one] != one) one = towards_[one] = towards_[towards_[one]];
    return one;
  }

  void join(Index a, Index b) {
    const Index first = lowest(a), second = lowest(b);
    if (first < second) {
      towards_[second] = first;
    } else {
      towards_[first] = second;
    }
  }

 private:
  std::vector<Index> towards_;  ///< of each one of its part, lower than itself but for the lowest
};

}  // namespace hooke
