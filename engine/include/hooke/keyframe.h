#pragma once

#include <string_view>
#include <vector>

#include <hooke/vec3.h>

namespace hooke {

/// A point of a particle's path: from its starting position it is displaced by this at this time.
struct Keyframe {
  double time = 0.0;                 ///< [s]
  Vec3 displacement = Vec3::Zero();  ///< [m]

  static constexpr std::string_view name = "keyframe";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("time", self.time);
    visit("displacement", self.displacement);
  }
};

/// A pose of a rigid body at a time: it is displaced by this, and turned by this about its axis.
struct RigidKeyframe {
  double time = 0.0;                 ///< [s]
  Vec3 displacement = Vec3::Zero();  ///< [m]
  double degrees = 0.0;              ///< [deg], right-handed; more than 360 are several turns

  static constexpr std::string_view name = "rigid_keyframe";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("time", self.time);
    visit("displacement", self.displacement);
    visit("degrees", self.degrees);
  }
};

/// The pose on a path at a time [s]: straight and even between keyframes, held before the first and after the
/// last; none on a path without any.
RigidKeyframe on_path(const std::vector<RigidKeyframe>& path, double time);

/// A force at a time.
struct ForceKeyframe {
  double time = 0.0;          ///< [s]
  Vec3 force = Vec3::Zero();  ///< [N]

  static constexpr std::string_view name = "force_keyframe";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("time", self.time);
    visit("force", self.force);
  }
};

}  // namespace hooke
