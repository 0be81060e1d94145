#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <hooke/executor.h>
#include <hooke/simulation.h>

#include "model/order.h"
#include "state.h"

namespace hooke {

/// Finds the springs that tear.
template <class Real>
class StrainedSprings {
 public:
  /// `relaxing` are springs beside what has torn, in ascending order.
  StrainedSprings(const Scene& scene, const Order& order, std::vector<RelaxingSpring> relaxing);

  /// Those that tear in a state, the most strained first. Springs that have relaxed in it are as all others
  /// from then on.
  std::vector<Index> find(const State<Real>& state, Executor& executor);

  const std::vector<RelaxingSpring>& relaxing() const { return relaxing_; }
  void relax(std::vector<RelaxingSpring> springs) { relaxing_ = std::move(springs); }
  std::size_t bytes() const;

 private:
  struct Spring {
    Index number, first, second;  ///< ends in the engine's order
    Real longest_square;          ///< [m^2]
  };
  /// One that is too long, and by how much: its stretch over that which it bears [1].
  struct Strained {
    Index number;
    double length, excess;
  };

  void look_at(std::size_t begin, std::size_t end, const State<Real>& state,
               std::vector<Strained>& found) const;
  void pass_over_relaxing(std::vector<Strained>& found);

  std::vector<Spring> springs_;                 ///< that can tear, by number
  std::vector<double> rest_, longest_;          ///< [m] of these
  std::vector<RelaxingSpring> relaxing_;        ///< by number
  std::vector<std::vector<Strained>> of_runs_;  ///< found in each run of springs
};

}  // namespace hooke
