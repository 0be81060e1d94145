#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <hooke/effects.h>
#include <hooke/executor.h>

#include "collide/axis_box.h"
#include "effects/effect_list.h"
#include "model/model.h"
#include "sleep/disturbances.h"
#include "sleep/island_members.h"
#include "state_ring.h"

namespace hooke {

/// Puts islands to sleep that have come to rest, and wakes them.
///
/// An island that is awake has for most of its life a particle that moves, so each piece of it remembers one
/// that did: as long as that one moves nothing else is looked at.
template <class Real>
class Sleepers final : Disturbances {
 public:
  /// Of steps of `step` [s]. `model` has islands.
  Sleepers(const Sleep& sleep, const Model<Real>& model, double step);

  /// Before a step from one time to another [s]: wakes what cannot be at rest in it.
  void begin_step(double from, double to, const EffectList<Real>& effects);

  /// Wakes what something awake has touched. Whether there was any: then the step is to be taken again.
  bool wake_touched();

  /// After a step, whose result is the newest state: wakes what is touched there by what is awake, and puts
  /// to sleep what has been at rest for long enough. What falls asleep has no velocity, in all states of the
  /// ring.
  void end_step(StateRing<Real>& states, Executor& executor);

  /// The islands of some particles of the user's, and those that fell asleep with them as they touched them.
  void wake(std::span<const Index> particles);
  void wake_all();

  /// See Snapshot::resting.
  std::vector<std::uint32_t> resting() const;

  /// As a snapshot has it; of as many islands, or empty. Those that sleep have no velocity in the newest
  /// state.
  void restore(std::span<const std::uint32_t> resting, StateRing<Real>& states);

  std::size_t particles_asleep() const;
  std::size_t bytes() const;

 private:
  /// A part of an island.
  struct Piece {
    Index island;
    std::span<const Index> particles;
    std::size_t witness = 0;  ///< the place of the one that moved when the piece was looked at last
    bool at_rest = false;
  };

  void all() override { all_disturbed_ = true; }
  void particle(Index particle) override { disturbed_[islands_.of(model_.order.user(particle))] = 1; }
  void box(const Vec3& low, const Vec3& high) override { boxes_.push_back({low, high}); }

  void disturb_moved_pins(double from, double to);
  bool is_disturbed(Index island, const AxisBox& around) const;
  bool moves(Index particle, const StateRing<Real>& states) const;
  void look(Piece& piece, const StateRing<Real>& states) const;
  void count_steps_at_rest();
  void choose_group_of(Index island) { chosen_[group_[island]] = 1, any_chosen_ = true; }
  void wake_chosen();
  std::vector<Index> groups_of_touching() const;
  void put_to_sleep(const std::vector<Index>& groups, StateRing<Real>& states);
  void stop(Index island, StateRing<Real>& states) const;
  AxisBox around(Index island, const State<Real>& state) const;

  const Model<Real>& model_;
  Islands& islands_;
  double square_speed_, step_;  ///< [m^2/s^2], [s]
  std::uint32_t enough_;        ///< steps at rest
  IslandMembers members_;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> steps_at_rest_;  ///< of each island that is awake
  std::vector<Index> group_;     ///< of each that sleeps: the lowest of those it fell asleep with
  std::vector<AxisBox> around_;  ///< each that sleeps
  std::vector<char> chosen_;     ///< of each group whether wake_chosen() wakes it
  std::vector<char> never_;      ///< of each whether it may not sleep
  bool any_chosen_ = false;
  bool all_disturbed_ = false;   ///< in this step
  std::vector<char> disturbed_;  ///< likewise, of each island
  std::vector<AxisBox> boxes_;   ///< likewise what is in them
};

}  // namespace hooke
