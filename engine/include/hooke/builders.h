#pragma once

#include <string_view>
#include <vector>

#include <hooke/materials.h>
#include <hooke/scene.h>

/// Builders: each adds particles, springs and triangles to a scene and returns the numbers of what it added.
/// A stiffness of zero means that springs of that kind are not made. Bad parameters throw SceneError and
/// leave the scene as it was.

namespace hooke {

/// Where a builder puts what it makes: first scaled, then turned about `rotation_axis`, then moved.
struct Placement {
  Vec3 translation{0.0, 0.0, 0.0};    ///< [m]
  Vec3 rotation_axis{0.0, 1.0, 0.0};  ///< any length but zero
  double rotation_degrees = 0.0;      ///< [deg], right-handed
  double scale = 1.0;                 ///< > 0

  static constexpr std::string_view name = "placement";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("translation", self.translation);
    visit("rotation_axis", self.rotation_axis);
    visit("rotation_degrees", self.rotation_degrees);
    visit("scale", self.scale);
  }
};

/// A hanging cloth of columns x rows particles in the x-y plane: columns go along +x, rows go down along -y,
/// particle (0, 0) is at the origin. Springs as in Provot 1995: structural (to the 4 neighbours), shear
/// (diagonals), bend (to the second neighbour). Each particle's mass is its share of the area, so the cloth's
/// mass does not depend on the resolution. With another law than naive springs its material counts in place
/// of areal_density, stretch, shear, bend and damping.
struct ClothGrid {
  Index columns = 32;          ///< particles along x, >= 2
  Index rows = 32;             ///< particles along y, >= 2
  double spacing = 0.02;       ///< [m], > 0
  double areal_density = 0.2;  ///< [kg/m^2], > 0
  double stretch = 1e3;        ///< stiffness of structural springs [N/m]
  double shear = 500.0;        ///< stiffness of shear springs [N/m]
  double bend = 10.0;          ///< stiffness of bend springs [N/m]
  double damping = 0.0;        ///< along every spring [N s/m]
  SheetLaw law = NaiveSprings{};
  Placement placement = {};

  static constexpr std::string_view name = "cloth_grid";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("columns", self.columns);
    visit("rows", self.rows);
    visit("spacing", self.spacing);
    visit("areal_density", self.areal_density);
    visit("stretch", self.stretch);
    visit("shear", self.shear);
    visit("bend", self.bend);
    visit("damping", self.damping);
    visit("law", self.law);
    visit("placement", self.placement);
  }
};

/// The particles of a cloth grid: numbered row by row from `first`.
struct GridParticles {
  Index first = 0, columns = 0, rows = 0;
  Index at(Index column, Index row) const { return first + row * columns + column; }
};

GridParticles add(Scene& scene, const ClothGrid& cloth);

/// A cloth from a triangle mesh: each edge becomes a structural spring, the corners of two triangles opposite
/// a shared edge a bend spring (an edge of more than two triangles, each pair of them). A third of each
/// triangle's mass goes to each corner. Vertices closer than `weld_tolerance` become one particle, so a seam
/// holds. With another law than naive springs its material counts in place of areal_density, stretch, bend
/// and damping.
struct ClothMesh {
  std::vector<Vec3> vertices = {};       ///< [m]
  std::vector<Triangle> triangles = {};  ///< into `vertices`
  double areal_density = 0.2;            ///< [kg/m^2], > 0
  double stretch = 1e3;                  ///< stiffness of edge springs [N/m]
  double bend = 10.0;                    ///< stiffness of bend springs [N/m]
  double damping = 0.0;                  ///< along every spring [N s/m]
  SheetLaw law = NaiveSprings{};
  double weld_tolerance = 1e-6;  ///< [m] in the mesh's own size, >= 0
  Placement placement = {};

  static constexpr std::string_view name = "cloth_mesh";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("areal_density", self.areal_density);
    visit("stretch", self.stretch);
    visit("bend", self.bend);
    visit("damping", self.damping);
    visit("law", self.law);
    visit("weld_tolerance", self.weld_tolerance);
    visit("placement", self.placement);
  }
};

/// The particles of a cloth made from a mesh.
struct MeshParticles {
  static constexpr Index none = ~Index{0};

  Index first = 0, count = 0;
  std::vector<Index> of_vertex;  ///< each vertex's particle, or none where no triangle of some area uses it
  std::size_t welded_vertices = 0;       ///< vertices that became part of another's particle
  std::size_t unused_vertices = 0;       ///< vertices left out: no triangle uses them
  std::size_t degenerate_triangles = 0;  ///< triangles left out: two equal corners after welding, or no area
};

MeshParticles add(Scene& scene, const ClothMesh& cloth);

/// A rope of evenly spaced particles from `start` to `end`. Structural springs join neighbours, bend springs
/// second neighbours.
struct Rope {
  Index particles = 32;          ///< >= 2
  Vec3 start{0.0, 0.0, 0.0};     ///< [m]
  Vec3 end{1.0, 0.0, 0.0};       ///< [m]
  double linear_density = 0.05;  ///< [kg/m], > 0
  double stretch = 1e3;          ///< stiffness of structural springs [N/m]
  double bend = 0.0;             ///< stiffness of bend springs [N/m]
  double damping = 0.0;          ///< along every spring [N s/m]

  static constexpr std::string_view name = "rope";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("particles", self.particles);
    visit("start", self.start);
    visit("end", self.end);
    visit("linear_density", self.linear_density);
    visit("stretch", self.stretch);
    visit("bend", self.bend);
    visit("damping", self.damping);
  }
};

/// The particles of a rope, in order from its start.
struct RopeParticles {
  Index first = 0, count = 0;
  Index at(Index i) const { return first + i; }
};

RopeParticles add(Scene& scene, const Rope& rope);

/// A soft block: a lattice of nx x ny x nz particles whose lowest corner is the origin. Structural springs
/// along the axes, shear springs across the faces of each cell, and across its body. Its surface is given as
/// triangles.
struct Block {
  Index nx = 8, ny = 8, nz = 8;  ///< particles along each axis, >= 2
  double spacing = 0.05;         ///< [m], > 0
  double density = 100.0;        ///< [kg/m^3], > 0
  double stretch = 1e3;          ///< stiffness along the axes [N/m]
  double shear = 500.0;          ///< stiffness across faces [N/m]
  double body = 500.0;           ///< stiffness across cells [N/m]
  double damping = 0.0;          ///< along every spring [N s/m]
  Placement placement = {};

  static constexpr std::string_view name = "block";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("nx", self.nx);
    visit("ny", self.ny);
    visit("nz", self.nz);
    visit("spacing", self.spacing);
    visit("density", self.density);
    visit("stretch", self.stretch);
    visit("shear", self.shear);
    visit("body", self.body);
    visit("damping", self.damping);
    visit("placement", self.placement);
  }
};

/// The particles of a block: x runs fastest, then y, then z.
struct BlockParticles {
  Index first = 0, nx = 0, ny = 0, nz = 0;
  Index at(Index i, Index j, Index k) const { return first + (k * ny + j) * nx + i; }
};

BlockParticles add(Scene& scene, const Block& block);

/// The particles numbered from `first`, `count` of them, that lie within `distance` [m] of the one furthest
/// along `direction` (any length but zero): {0, 1, 0} and 0.02 give the top 2 cm.
std::vector<Index> furthest_along(const Scene& scene, Index first, Index count, const Vec3& direction,
                                  double distance);

/// Bending along the rows and columns of a grid of square cells, for a sheet of bending stiffness D >= 0 [N
/// m]: k = D b / a^3 with a the spacing [m], > 0, and b the width that a line stands for: a, and half of it
/// for the lines at the border. Converges to 1/2 D (curvature along rows^2 + curvature along columns^2) per
/// area. Throws SceneError where spacing or stiffness are bad.
LaplacianBending bending_of(const GridParticles& grid, double spacing, double stiffness);

/// Bending of a rope of bending stiffness EI >= 0 [N m^2] whose particles are `spacing` [m] apart, > 0:
/// k = EI / a^3.
LaplacianBending bending_of(const RopeParticles& rope, double spacing, double stiffness);

}  // namespace hooke
