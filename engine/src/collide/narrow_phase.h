#pragma once

#include <span>
#include <vector>

#include <hooke/executor.h>

#include "collide/close_pairs.h"
#include "collide/contact_sweeps.h"

namespace hooke {

/// Which of the close pairs touch in a step, and where.
class NarrowPhase {
 public:
  NarrowPhase(double thickness, double friction, bool swept)
      : thickness_(thickness), friction_(friction), swept_(swept) {}

  /// Pairs get contacts from this distance on [m]: what others push towards them in the same step is kept
  /// apart with them.
  static double active_distance(double thickness) { return 1.25 * thickness; }

  /// A step as far as pairs are concerned.
  struct Step {
    const Places &start, &end;
    const std::vector<double>& inverse_mass;
    double moved;   ///< at least what two particles have moved against each other since pairs were found [m]
    double motion;  ///< the same of the step [m]
    double h;       ///< [s]
  };

  /// The contacts of all pairs, in their order. What passes gets them where it is when it comes near, else
  /// where it is at the end. Valid until the next call.
  std::vector<SurfaceContact>& contacts_of(const std::vector<ClosePair>& pairs, const Step& step,
                                           Executor& executor);

  /// Whether one of these was of a pair that passes, or would without it; or a pair without a contact passes.
  bool passed() const { return passed_; }

  /// The pairs that come much nearer on their straight ways than they were at the start: a tenth, of what is
  /// less of that and of their thickness.
  const std::vector<ClosePair>& crossing(const std::vector<ClosePair>& pairs, const Step& step,
                                         Executor& executor);

  std::size_t bytes() const;

 private:
  /// How a pair has got a contact.
  struct Touch {
    const ClosePair* pair;
    double time;             ///< when it comes near, as a share of the step; 1 where it does not pass
    double distance;         ///< then [m]
    double distance_at_end;  ///< of the step [m]
    bool is_left = false;    ///< to another pair
  };

  struct Run {
    std::vector<SurfaceContact> contacts;
    std::vector<Touch> of_corner;  ///< of the last contacts, which are of one corner
    std::vector<ClosePair> crossing;
    bool passed = false;
  };

  /// Up to this distance a pair has a contact.
  double reach_of(const ClosePair& pair) const {
    return pair.thickness < thickness_ ? pair.thickness : active_distance(thickness_);
  }
  bool is_far(const ClosePair& pair, const Step& step) const {
    return pair.distance - step.moved > reach_of(pair);
  }
  /// What a pair is kept apart by that was `before` apart at the start, in the direction of its contact [m].
  double least_distance(const ClosePair& pair, double before, double h) const;

  template <class Look>
  std::span<const Run> look_at(const std::vector<ClosePair>& pairs, const Look& look, Executor& executor);
  void look(const ClosePair& pair, const Step& step, Run& run) const;
  bool is_left_to_others(const SurfaceContact& contact, const Touch& touch, const Step& step) const;
  static void leave_nearest(const Step& step, Run& run);
  static bool passes(const Touch& touch, const Step& step);
  static bool is_crossing(const ClosePair& pair, const Step& step, double distance_at_end);

  double thickness_, friction_;
  bool swept_, passed_ = false;
  std::vector<Run> runs_;
  std::vector<SurfaceContact> contacts_;
  std::vector<std::size_t> begin_;  ///< of each run's, in `contacts_`
  std::vector<ClosePair> crossing_;
};

}  // namespace hooke
