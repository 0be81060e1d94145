#pragma once

#include <limits>
#include <vector>

#include <hooke/executor.h>

#include "collide/close_pairs.h"
#include "collide/motion_bound.h"
#include "substep.h"

namespace hooke {

/// The close pairs of a surface, found with a margin, so that they last for as many steps as particles take
/// to use it up. Where cloth lies on nothing the margin is wide, and pairs are looked for where particles are
/// going to be, so that they last for longer.
template <class Real>
class LastingPairs {
 public:
  /// `rest`: as in ClosePairs; `edge`: the mean one there [m]. `from_starts`: pairs are asked for what is
  /// near in a step, else only at its end.
  LastingPairs(const Surface& surface, const Places& rest, double thickness, double edge, bool from_starts);

  /// Whether those found last are still all that may touch in this step.
  bool hold_in(const StepResult<Real>& result, Executor& executor);

  /// Finds them anew, from the places of this step's start and end. Whether these were all finite: else there
  /// are none.
  bool find(const StepResult<Real>& result, const Places& start, const Places& end, Executor& executor);

  const std::vector<ClosePair>& found() const { return *pairs_; }

  /// Whether a pair may touch in the step.
  bool may_touch() const;

  /// At least what two particles have moved against each other since [m].
  double moved() const { return moved_; }

  /// The same of one step [m].
  double motion_in(const StepResult<Real>& result, Executor& executor) const {
    return bound_.between(result.start, result.next, executor);
  }

  /// The boxes that the last ones were found by.
  const ClosePairs& boxes() const { return close_pairs_; }
  /// Where they were found; null where that was along the ways of one step.
  const Places* looked_at() const { return hold_ ? &looked_ : nullptr; }
  /// So much further apart than contacts are they were looked for [m].
  double margin() const { return margin_; }

  std::size_t bytes() const {
    return close_pairs_.bytes() + bound_.bytes() + looked_.capacity() * sizeof(Vec3);
  }

 private:
  /// Pairs are looked for that are so much further apart than contacts are [m]: the more, the longer they
  /// last, and the more they are.
  struct Margins {
    double narrow;  ///< where cloth lies on cloth
    double wide;    ///< elsewhere: neighbours that share no particle should not be pairs

    Margins(double thickness, double edge);
  };

  void measure_motion(const StepResult<Real>& result, Executor& executor);
  void look_ahead(const StepResult<Real>& result, Executor& executor);
  void look(const StepResult<Real>& result, double moment, Executor& executor);
  bool are_finite(const Places& start, const Places& end) const;
  double longest_edge() const;

  const Surface& surface_;
  double thickness_;
  bool from_starts_;
  Margins margins_;
  double margin_;  ///< of the pairs that are known
  ClosePairs close_pairs_;
  MotionBound<Real> bound_;
  Places looked_;  ///< where pairs were looked for
  const std::vector<ClosePair> no_pairs_;
  const std::vector<ClosePair>* pairs_ = &no_pairs_;
  bool hold_ = false;
  bool is_crowd_ = true;  ///< whether much lay on one another when pairs were found last
  double moved_ = 0.0;
  double nearest_ = std::numeric_limits<double>::infinity();  ///< of the pairs when they were found [m]
};

}  // namespace hooke
