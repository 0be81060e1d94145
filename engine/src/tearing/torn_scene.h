#pragma once

#include <span>
#include <vector>

#include <hooke/simulation.h>

namespace hooke {

/// A scene after some of its springs have torn, and where everything in it comes from.
struct TornScene {
  static constexpr Index none = ~Index{0};

  Scene scene;
  std::vector<Index> split_from;         ///< of each particle that is new, the one that it was split from
  std::vector<Index> spring_from;        ///< of each spring, its number before, or of that it is a part of
  std::vector<Index> number_after;       ///< of each spring before: none of one that is gone
  std::vector<RelaxingSpring> relaxing;  ///< the springs at particles that were split, and what was let be

  /// Whether anything has come apart.
  bool torn() const;
};

/// Tears a scene without faults at `springs`, one after the other, with its particles at `positions`. Of each
/// spring one end is split in two by the plane through it across the spring: the new particle gets the
/// triangles on the spring's side and their edges; an edge of triangles on both sides becomes two springs
/// that share its stiffness and damping, and mass is shared as the triangles' area at rest is. Springs that
/// are no edges (shear, bending) go with the triangles that lead to their other end; where no two edges
/// do any more they would bridge the tear, and are gone. Where there are no triangles springs go by their
/// other ends' side, and one that leads straight through the particle is gone.
///
/// Of the two ends it is one that is not held (pinned, attached, scripted), at the border of the triangles,
/// with the most on its weaker side; the first of equal ones. An end with nothing on one side is not split:
/// of two such ends the spring is gone, but where it is an edge and is let be. The new particle of one that
/// was held is free. At each particle only one of `springs` tears.
TornScene tear(const Scene& scene, std::vector<Vec3> positions, std::span<const Index> springs);

}  // namespace hooke
