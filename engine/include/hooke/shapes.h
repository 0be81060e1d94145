#pragma once

#include <string_view>
#include <variant>

#include <hooke/vec3.h>

namespace hooke {

/// The solids that particles collide with, as they lie at zero displacement and rotation.

/// All that is below a plane: normal . x < height.
struct PlaneShape {
  Vec3 normal{0.0, 1.0, 0.0};  ///< out of the solid; any length but zero
  double height = 0.0;         ///< along the unit normal [m]

  static constexpr std::string_view name = "plane";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("normal", self.normal);
    visit("height", self.height);
  }
};

struct SphereShape {
  Vec3 centre{0.0, 0.0, 0.0};  ///< [m]
  double radius = 0.5;         ///< [m], > 0

  static constexpr std::string_view name = "sphere";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("centre", self.centre);
    visit("radius", self.radius);
  }
};

/// All that is within a radius of a line between two points.
struct CapsuleShape {
  Vec3 start{0.0, 0.0, 0.0};  ///< [m]
  Vec3 end{0.0, 1.0, 0.0};    ///< [m]
  double radius = 0.25;       ///< [m], > 0

  static constexpr std::string_view name = "capsule";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("start", self.start);
    visit("end", self.end);
    visit("radius", self.radius);
  }
};

/// Its sides lie along the axes.
struct BoxShape {
  Vec3 centre{0.0, 0.0, 0.0};     ///< [m]
  Vec3 half_size{0.5, 0.5, 0.5};  ///< [m], each > 0

  static constexpr std::string_view name = "box";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("centre", self.centre);
    visit("half_size", self.half_size);
  }
};

using ColliderShape = std::variant<PlaneShape, SphereShape, CapsuleShape, BoxShape>;

}  // namespace hooke
