#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <hooke/scene.h>

#include "picture/solid.h"

namespace hooke::picture {

/// What there is to draw of a scene: all of it that stays the same while it moves. Numbers are the user's.
struct Subject {
  std::size_t particles = 0;
  std::vector<Triangle> triangles = {};
  std::vector<std::array<Index, 2>> springs = {};
  std::vector<float> rest_lengths = {};  ///< [m] of each spring
  std::vector<Index> pins = {};
  std::vector<GroundPlane> grounds = {};  ///< plane colliders, too
  std::vector<Solid> solids = {};         ///< the other colliders
  Vec3 up{0.0, 1.0, 0.0};                 ///< against gravity where there is one, else y; unit length
};

Subject subject_of(const Scene& scene);

/// The subject of a scene after that has torn.
Subject torn_subject(Subject subject, const Scene& torn);

/// The ground planes, and the planes that are colliders, where these are at the start.
std::vector<GroundPlane> grounds_of(const std::vector<Effect>& effects);

/// Which parts of a subject are drawn, and how.
struct Look {
  bool surface = true;    ///< triangles, lit from both sides
  bool springs = true;    ///< as lines, coloured by strain: blue pressed, grey at rest, red stretched
  bool particles = true;  ///< as points
  bool pins = true;       ///< as larger points
  bool ground = true;     ///< the ground planes; where there is none, a floor under the scene
  bool solids = true;     ///< colliders that are no planes
  bool shadow = true;
  double time = 0.0;         ///< [s] at which moving colliders are shown
  double full_strain = 0.1;  ///< [1] at which the colour of a spring is full, > 0
  /// [m] along `up`, of the floor; none: a little under the positions that are drawn. A movie gives one, or
  /// its floor would sink with the scene.
  std::optional<double> floor_height = {};
};

/// What shows a subject best: its surface where it has triangles, its springs where they would not be hidden
/// by it, and particles where neither shows them.
Look look_for(const Subject& subject);

}  // namespace hooke::picture
