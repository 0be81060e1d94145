#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <hooke/scene.h>

#include "picture/multisampled_target.h"
#include "picture/renderer.h"
#include "viewer/camera_control.h"
#include "viewer/floor.h"
#include "viewer/live/moment.h"
#include "viewer/viewport.h"

namespace hooke::viewer {

/// The scene in the window: draws the newest moment, as its camera sees it.
class SceneView {
 public:
  /// Keeps what is drawn of the scene, not the scene.
  explicit SceneView(const Scene& scene);

  /// Takes the newest state, which must stay until the next is taken.
  void take(const Moment& moment);
  /// For ground planes that were moved.
  void take(const std::vector<Effect>& effects);

  /// Draws all of `viewport` [pixels], which begins at this pixel of the window, counted from the lower left.
  void draw(const Viewport& viewport, int left, int bottom, double seconds);

  /// Shows all of it.
  void fit();

  /// The particle that can be dragged from this place [pixels], if any.
  std::optional<Index> particle_at(const Eigen::Vector2d& pixel, double radius) const;
  Vec3 position(Index particle) const;  ///< [m]
  /// Where a particle is seen [pixels]; nothing where it is behind the eye.
  std::optional<Eigen::Vector2d> place_of(Index particle) const;

  CameraControl& camera() { return camera_; }
  const CameraControl& camera() const { return camera_; }
  const Viewport& viewport() const { return viewport_; }
  picture::Look& look() { return look_; }

  /// What was drawn last, without the panels.
  picture::Image image() const { return target_->image(); }

 private:
  void show(std::shared_ptr<const Scene> torn);

  picture::Renderer renderer_;
  picture::Subject whole_;             ///< before the scene has torn
  std::shared_ptr<const Scene> torn_;  ///< null: whole
  picture::Look look_;
  CameraControl camera_;
  Floor floor_;
  Viewport viewport_;
  std::optional<picture::MultisampledTarget> target_;
  std::span<const float> positions_;
  std::vector<bool> pinned_;
  bool fitted_ = false;
};

}  // namespace hooke::viewer
