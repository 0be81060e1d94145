#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include <hooke/index.h>
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

/// All that a closed surface of triangles encloses. It turns about the middle of the box around it.
struct MeshShape {
  std::vector<Vec3> vertices = {};       ///< those at one place are one
  std::vector<Triangle> triangles = {};  ///< into `vertices`, with corners anticlockwise from outside
  double scale = 1.0;                    ///< of `vertices` [m], > 0

  static constexpr std::string_view name = "mesh";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("vertices", self.vertices);
    visit("triangles", self.triangles);
    visit("scale", self.scale);
  }
};

/// The ground below heights over a grid of points, with upright walls at its sides: columns along x and rows
/// along z from `corner`. Each square of four neighbours is two triangles, along the diagonal from its lowest
/// x and z. It turns about the middle of the box around it.
struct HeightfieldShape {
  Index columns = 2;                 ///< >= 2
  Index rows = 2;                    ///< >= 2
  double spacing = 1.0;              ///< between neighbours [m], > 0
  std::vector<double> heights = {};  ///< columns times rows, row by row, over corner.y [m]
  Vec3 corner{0.0, 0.0, 0.0};        ///< [m]
  double depth = 1.0;                ///< of the ground under the lowest height [m], > 0

  static constexpr std::string_view name = "heightfield";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("columns", self.columns);
    visit("rows", self.rows);
    visit("spacing", self.spacing);
    visit("heights", self.heights);
    visit("corner", self.corner);
    visit("depth", self.depth);
  }
};

using ColliderShape =
    std::variant<PlaneShape, SphereShape, CapsuleShape, BoxShape, MeshShape, HeightfieldShape>;

/// What a shape turns about [m]: its middle, of a plane the world's origin.
Vec3 origin_of(const ColliderShape& shape);

}  // namespace hooke
