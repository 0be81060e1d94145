#pragma once

#include <vector>

#include "collide/close_pairs.h"
#include "collide/contact_masses.h"
#include "collide/contact_sweeps.h"
#include "collide/obstacles.h"

namespace hooke {

/// How cloth that is kept apart from cloth lies on the colliders of a scene. What lies on one is not pushed
/// into it: it carries what lies on it. What is deep in several is pinched: colliders leave it there, and so
/// does all else.
class ObstacleContacts {
 public:
  /// Where the scene has a collider it has frames. `thickness`: that cloth is kept apart by [m].
  ObstacleContacts(const Scene& scene, const Frames* frames, PreparedMeshes& meshes, double thickness,
                   ContactMasses& masses)
      : obstacles_(scene, frames, meshes, thickness), thickness_(thickness), masses_(masses) {}

  /// Colliders are as at `time` [s], the end of a step of `h` [s].
  void move_to(double time, double h);

  /// Holds what is pinched of these particles.
  void hold_pinched(const std::vector<Index>& particles, const Places& places);

  /// Takes back as much of the moves of particles that led to these places as went into colliders [m].
  void keep_out(const std::vector<Index>& particles, const Places& moves, Places& places) const;

  /// Adds the contacts of these particles, sorted, with colliders to those of pairs. Holds what is pinched,
  /// and leaves out the contacts that it takes part in, and those of pieces that are squeezed: so near that
  /// there is no room for both between colliders that they lie on, which hold each against the push of the
  /// other. Returns how many contacts of pairs there are then, which come first.
  std::size_t add_to(std::vector<SurfaceContact>& contacts, const std::vector<Index>& particles,
                     const Places& start, const Places& end, Executor& executor);

  /// Of the contacts that were added: the velocity of the collider there [m/s].
  const std::vector<Vec3>& velocities() const { return velocities_; }

  std::size_t bytes() const { return obstacles_.bytes() + is_left_out_.capacity(); }

 private:
  /// What is so deep in several is pinched.
  bool is_deep(const ObstacleSurface& surface) const { return surface.gap < -0.01 * thickness_; }

  bool is_pinched(Index particle, const Places& places) const;
  void find(Index particle, const Places& start, const Places& end);
  void leave_out(std::vector<SurfaceContact>& contacts, const Places& end, Executor& executor);
  bool is_squeezed(const SurfaceContact& contact, const Places& end) const;
  bool is_held(const SurfaceContact& contact, double side) const;

  Obstacles obstacles_;
  double thickness_, h_ = 0.0;
  ContactMasses& masses_;
  std::vector<SurfaceContact> contacts_;    ///< the last ones, sorted by particle
  std::vector<Vec3> velocities_;            ///< of each of these
  std::vector<unsigned char> is_left_out_;  ///< of each contact of pairs
};

}  // namespace hooke
