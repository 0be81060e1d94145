#pragma once

#include <string_view>

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
