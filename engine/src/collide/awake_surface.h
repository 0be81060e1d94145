#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "collide/axis_box.h"
#include "collide/close_pairs.h"
#include "collide/strip_bounds.h"
#include "model/model.h"
#include "sleep/island_members.h"
#include "substep.h"

namespace hooke {

/// The part of a surface of which something may touch in a step: islands that are awake, and those asleep
/// that one of these comes near. Where nothing sleeps it is the whole surface.
template <class Real>
class AwakeSurface {
 public:
  /// What comes within `reach` [m] of each other may touch.
  AwakeSurface(Surface whole, const Model<Real>& model, double reach);

  const Surface& surface() const { return part_; }

  /// Chooses it for a step. Whether it has changed.
  bool choose(const StepResult<Real>& result);

  /// Whether something that sleeps is a part of it.
  bool any_sleeps() const { return any_sleeps_; }

  /// Whether all particles of a pair sleep.
  bool sleeps(const std::array<Index, 4>& particles) const {
    return model_.sleeps(particles[0]) && model_.sleeps(particles[3]);
  }

  /// That the two of a pair touch, where they are of two islands.
  void note_touch(const std::array<Index, 4>& particles) const {
    if (model_.islands == nullptr) return;
    model_.islands->note_touch(model_.order.user(particles[0]), model_.order.user(particles[3]));
  }

  std::size_t bytes() const;

 private:
  void look(const StepResult<Real>& result, bool asleep_too);
  bool is_any_left_out_near() const;
  void find_near();
  void take_part();
  Index island_of(Index particle) const { return model_.islands->of(model_.order.user(particle)); }

  const Model<Real>& model_;
  double reach_;
  Surface whole_, part_;
  IslandMembers corners_;        ///< of the whole surface
  std::vector<AxisBox> around_;  ///< each island's corners in this step [m]
  std::vector<char> taken_;      ///< of each island whether it is in the part
  BoundsList<double> left_out_;  ///< around islands that are not, wider by the reach
  bool any_sleeps_ = false;
  std::uint64_t islands_seen_ = 0;
};

}  // namespace hooke
