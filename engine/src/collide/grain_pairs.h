#pragma once

#include <span>
#include <vector>

#include <hooke/executor.h>
#include <hooke/index.h>

#include "collide/box_tree.h"
#include "collide/motion_bound.h"
#include "state.h"

namespace hooke {

/// A particle with a radius.
struct Grain {
  Index particle;  ///< of the user's numbering
  Index place;     ///< in the engine's order
  double radius;   ///< [m]
};

std::vector<Index> sorted_places(const std::vector<Grain>& grains);

/// Two grains that may touch.
struct GrainPair {
  Index first, second;              ///< of the user's numbering, first < second
  Index first_place, second_place;  ///< in the engine's order
  double reach;                     ///< the sum of their radii [m]
};

/// The pair of a grain, and whether it is the second one in it.
struct PairOfGrain {
  Index pair;
  bool is_second;
};

/// Grains that are near each other (Verlet 1967): found with a margin, and anew where grains have moved
/// against each other by more than that since.
template <class Real>
class GrainPairs {
 public:
  /// Among so many particles, sorted by the user's numbering; `apart` are pairs of particles in that, sorted,
  /// that do not touch whatever their distance.
  GrainPairs(std::vector<Grain> grains, std::size_t particles, std::vector<std::pair<Index, Index>> apart);

  /// Finds them in this state, unless those that are known hold. Sorted, and with all that touch.
  std::span<const GrainPair> find(const State<Real>& state, Executor& executor);

  /// Those found last.
  std::span<const GrainPair> pairs() const { return pairs_; }

  /// The pairs of a place in the engine's order among those found last, in their order.
  std::span<const PairOfGrain> of(std::size_t place) const {
    return {of_.data() + begin_[place], begin_[place + 1] - begin_[place]};
  }

  std::size_t bytes() const;

 private:
  void find_anew(const State<Real>& state, Executor& executor);
  void add_if_near(std::size_t grain, std::size_t other, std::vector<GrainPair>& found) const;
  void list_by_place();

  std::vector<Grain> grains_;
  std::vector<std::pair<Index, Index>> apart_;
  double largest_ = 0.0, margin_ = 0.0;  ///< radius; how much further apart than they touch pairs may be [m]
  MotionBound<Real> bound_;
  bool known_ = false;
  std::vector<AxisBox> boxes_;
  BoxTree tree_;
  struct Run {
    std::vector<std::size_t> near;
    std::vector<GrainPair> found;
  };
  std::vector<Run> runs_;
  std::vector<GrainPair> pairs_;
  std::vector<std::size_t> begin_;
  std::vector<PairOfGrain> of_;
};

}  // namespace hooke
