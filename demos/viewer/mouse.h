#pragma once

#include <optional>

#include "viewer/state.h"

namespace hooke::viewer {

/// What the mouse does in the scene: drags particles and moves the camera.
class Mouse {
 public:
  /// Goes by ImGui's mouse of this frame. `origin` is the upper left corner of the scene in its units, of
  /// which each has `pixels_per_unit` pixels; `scale` is that of the interface [1].
  void act(State& state, const Eigen::Vector2d& origin, double pixels_per_unit, double scale);

  /// Draws the line from a particle that is dragged to the mouse, and marks one that could be.
  void draw(const State& state, const Eigen::Vector2d& origin, double pixels_per_unit, double scale) const;

  bool drags() const { return dragged_.has_value(); }

 private:
  enum class Doing { nothing, orbit, pan, drag };

  void press(State& state, double radius);
  void move(State& state);
  void release(State& state);
  void hover(State& state, double radius);

  Doing doing_ = Doing::nothing;
  Eigen::Vector2d pixel_ = Eigen::Vector2d::Zero(), last_ = Eigen::Vector2d::Zero();
  std::optional<Index> dragged_, hovered_;
  double depth_ = 0.0;      // [m] at which the mouse pulls
  double moved_at_ = -1e9;  // [s] of ImGui's time
};

}  // namespace hooke::viewer
