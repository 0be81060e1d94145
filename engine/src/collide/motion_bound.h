#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <hooke/executor.h>
#include <hooke/index.h>
#include <hooke/vec3.h>

#include "state.h"

namespace hooke {

/// How far particles have moved against others near them since they were looked at. What near ones share of
/// their motion does not count, nor how they move against what is far away, until that may come near.
///
/// Particles are in cells of a size; a cell's displacements and those of its neighbours lie in a box, whose
/// diagonal is the bound. That is measured only where what all have moved since it was measured last, which
/// takes one pass in vectors, might use up what was left.
template <class Real>
class MotionBound {
 public:
  /// The particles' numbers in the engine's order, sorted.
  explicit MotionBound(const std::vector<Index>& particles);

  /// Remembers where they are at a moment of this step: 0 is its start, 1 its end, and more where they are
  /// going to be after it if they go on as in it. choose_near() must follow.
  void look(const State<Real>& start, const State<Real>& next, double moment);

  /// Two of them are near each other where they are less than `far` [m] apart there; farther ones may come
  /// `far_motion` [m] nearer to each other.
  void choose_near(double far, double far_motion);

  /// Where it has looked at a particle [m].
  Vec3 looked(Index particle) const {
    return {double(looked_.of[0][particle]), double(looked_.of[1][particle]),
            double(looked_.of[2][particle])};
  }

  /// At least as much as any two that are near each other have moved against each other since [m], at both
  /// ends of a step; exact only where it is more than `enough`. Infinite where what is far may come near.
  double since(const State<Real>& start, const State<Real>& next, double enough, Executor& executor);

  /// At least as much as any two move against each other [m].
  double between(const State<Real>& before, const State<Real>& after, Executor& executor) const;

  std::size_t bytes() const;

 private:
  /// Numbers that follow one another.
  struct Run {
    std::size_t begin, end;
  };
  /// A box around displacements.
  struct Extents {
    Real low[3], high[3];

    Extents() {
      std::fill(low, low + 3, std::numeric_limits<Real>::infinity());
      std::fill(high, high + 3, -std::numeric_limits<Real>::infinity());
    }
    void add(const Extents& other) {
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], other.low[k]);
        high[k] = std::max(high[k], other.high[k]);
      }
    }
    void add(std::size_t k, Real value) {
      low[k] = std::min(low[k], value);
      high[k] = std::max(high[k], value);
    }
    double diagonal() const;
  };
  struct Places {
    std::vector<Real> of[3];

    void remember(const State<Real>& state);
    void move_on(const State<Real>& start, const State<Real>& next, Real share);
  };
  using Arrays = const Real* [3];

  void sort_into_cells(double size);
  void find_neighbours(const std::vector<std::uint64_t>& keys);
  void measure(const State<Real>& start, const State<Real>& next);
  Extents extents_of(const Arrays& before, const State<Real>& after, Executor& executor) const;

  std::vector<Run> runs_;
  Places looked_, measured_;  ///< where particles were then
  double far_motion_ = 0.0;
  double near_moved_ = 0.0, all_moved_ = 0.0;  ///< between looked_ and measured_
  std::vector<Index> cell_;                    ///< of each particle of the runs
  std::size_t cells_ = 0;
  std::vector<std::pair<Index, Index>> neighbours_;  ///< cells that touch, each with itself too
  std::vector<Extents> cell_extents_;
  mutable std::vector<Extents> extents_;  ///< room for those of the runs
};

}  // namespace hooke
