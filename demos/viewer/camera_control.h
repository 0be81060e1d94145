#pragma once

#include <span>

#include <Eigen/Geometry>

#include "picture/camera.h"
#include "viewer/viewport.h"

namespace hooke::viewer {

/// A camera that the mouse moves. It glides to where it is sent within about a tenth of a second. Until the
/// user moves it, it keeps everything in sight that has been seen so far.
class CameraControl {
 public:
  explicit CameraControl(const Vec3& up);

  const picture::Camera& camera() const { return shown_; }

  /// Turns around the target by a movement of the mouse [pixels].
  void orbit(const Eigen::Vector2d& moved, const Viewport& viewport);
  /// Moves so that what lies at the target's depth stays under the mouse.
  void pan(const Eigen::Vector2d& moved, const Viewport& viewport);
  /// Goes nearer by notches of the wheel (further: negative), towards what is under the mouse [pixel].
  void zoom(double notches, const Eigen::Vector2d& pixel, const Viewport& viewport);

  /// Shows all points (x, y, z of each [m]), and follows them from here on until the user moves the camera.
  void fit(std::span<const float> points, const Viewport& viewport);
  /// Takes new points into sight, if it still follows.
  void follow(std::span<const float> points, const Viewport& viewport);

  /// Goes on for `seconds` [s] of wall time.
  void advance(double seconds);
  /// Ends a movement at once.
  void arrive() { shown_ = goal_; }
  /// Whether it still moves.
  bool moves() const;

 private:
  void fit_box(const Viewport& viewport);

  picture::Camera goal_, shown_;
  Eigen::AlignedBox3f seen_;
  bool follows_ = true;
};

}  // namespace hooke::viewer
