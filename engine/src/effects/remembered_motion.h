#pragma once

#include <vector>

#include <hooke/index.h>

#include "state.h"

namespace hooke {

/// The places and velocities of some particles in a state, to know that state again: for what has been found
/// of it, and need not be found twice.
template <class Real>
class RememberedMotion {
 public:
  /// Numbers in the engine's order, sorted.
  explicit RememberedMotion(const std::vector<Index>& particles);

  void remember(const State<Real>& state);
  void forget() { known_ = false; }

  /// Whether these are the same, bit for bit, as when they were remembered; false where nothing is.
  bool is_of(const State<Real>& state) const;

  std::size_t bytes() const;

 private:
  /// Numbers that follow one another.
  struct Run {
    std::size_t begin, end;
  };

  std::vector<Run> runs_;
  std::vector<Real> values_;  ///< run by run, of each its six arrays
  bool known_ = false;
};

}  // namespace hooke
