#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include <hooke/executor.h>
#include <hooke/index.h>

#include "state.h"

namespace hooke {

/// How far some particles have moved against one another since they were looked at. What all of them share
/// of their motion does not count.
template <class Real>
class MotionBound {
 public:
  /// The particles' numbers in the engine's order, sorted.
  explicit MotionBound(const std::vector<Index>& particles);

  /// Remembers where they are.
  void look(const State<Real>& state);

  /// At least as much as any two of them have moved against each other since [m]: the diagonal of the box
  /// around their displacements.
  double since(const State<Real>& state, Executor& executor) const;

  /// The same between two states.
  double between(const State<Real>& before, const State<Real>& after, Executor& executor) const;

  std::size_t bytes() const {
    return (x_.capacity() + y_.capacity() + z_.capacity()) * sizeof(Real) + runs_.capacity() * sizeof(Run);
  }

 private:
  /// Numbers that follow one another.
  struct Run {
    std::size_t begin, end;
  };
  /// The smallest and the largest displacement along an axis.
  struct Extent {
    Real low = std::numeric_limits<Real>::infinity(), high = -std::numeric_limits<Real>::infinity();
  };
  struct Extents {
    Extent axis[3];

    void add(const Extents& other) {
      for (std::size_t k = 0; k < 3; ++k) {
        axis[k].low = std::min(axis[k].low, other.axis[k].low);
        axis[k].high = std::max(axis[k].high, other.axis[k].high);
      }
    }
  };

  double diagonal(const Real* const before[3], const State<Real>& after, Executor& executor) const;

  std::vector<Run> runs_;
  std::vector<Real> x_, y_, z_;
  mutable std::vector<Extents> extents_;  ///< room for those of the runs
};

}  // namespace hooke
