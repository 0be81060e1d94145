#pragma once

#include <array>
#include <string_view>
#include <variant>

/// What sheets are made of. A material belongs to the sheet and not to its mesh: builders that are given one
/// work out what holds each particle, so that the sheet stretches alike however finely it is divided.

namespace hooke {

/// A sheet that is equally stiff in all directions. What resists bending is the effect LaplacianBending in a
/// grid and HingeBending in a mesh, which the builders add where there is a bending stiffness.
struct SheetMaterial {
  double modulus = 0.0;              ///< Young's modulus times thickness [N/m], > 0
  double poisson_ratio = 1.0 / 3.0;  ///< [1], > -1 and < 1
  double areal_density = 0.2;        ///< [kg/m^2], > 0
  double damping = 0.0;              ///< of the rate of strain, over the stiffness [s], >= 0
  double bending_stiffness = 0.0;    ///< D [N m], >= 0

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("modulus", self.modulus);
    visit("poisson_ratio", self.poisson_ratio);
    visit("areal_density", self.areal_density);
    visit("damping", self.damping);
    visit("bending_stiffness", self.bending_stiffness);
  }
};

struct Fabric {
  std::string_view name;
  SheetMaterial sheet;
};

/// A fabric of this Young's modulus E [Pa], Poisson's ratio nu [1], density [kg/m^3] and thickness t [m]:
/// its sheet's modulus is E t, D = E t^3 / (12 (1 - nu^2)).
constexpr Fabric fabric_of(std::string_view name, double young, double poisson_ratio, double density,
                           double thickness) {
  return {name,
          {.modulus = young * thickness,
           .poisson_ratio = poisson_ratio,
           .areal_density = density * thickness,
           .bending_stiffness =
               young * thickness * thickness * thickness / (12.0 * (1.0 - poisson_ratio * poisson_ratio))}};
}

/// Real fabrics, with the values of the scenes of Li, Kaufman, Jiang 2021 (Codimensional Incremental
/// Potential Contact). There Young's modulus is fitted to bending, and what resists stretch is a tenth of it
/// to all of it, as the scene says. For paper no Poisson's ratio is given; 0.3 is taken here.
inline constexpr std::array fabrics{
    fabric_of("cotton", 0.821e6, 0.243, 472.6, 0.318e-3),
    fabric_of("wool", 0.170e6, 0.277, 413.4, 0.568e-3),
    fabric_of("wool_lycra", 0.076e6, 0.071, 543.3, 0.328e-3),
    fabric_of("polyester", 0.478e6, 0.381, 653.2, 0.252e-3),
    fabric_of("paper", 3e9, 0.3, 800.0, 0.3e-3),
};

/// The builder's own stiffnesses, the same for each spring of a kind: the sheet depends on its mesh.
struct NaiveSprings {
  static constexpr std::string_view name = "naive_springs";
  template <class Self, class Visit>
  static void fields(Self&, Visit&&) {}
};

/// Springs along edges with the stiffness that the mesh asks for. In a grid, with both diagonals of each cell
/// (k1 = 3/4 E, k2 = 3/8 E, halves along the rim), the sheet has exactly its modulus where nu = 1/3; springs
/// can be of no other. In a mesh by the rule of Van Gelder 1998: an edge of length c gets of each of its
/// triangles, whose other sides are a and b and whose area is A,
///   E / (1 + nu) A / c^2 + E nu / (1 - nu^2) (a^2 + b^2 - c^2) / 8A.
/// It is exact where all triangles are equilateral and nu = 1/3, and near elsewhere.
struct CalibratedSprings {
  SheetMaterial sheet = {};

  static constexpr std::string_view name = "calibrated_springs";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    SheetMaterial::fields(self.sheet, visit);
  }
};

/// No springs, but the effect TensileTriangles: exact on any mesh of triangles and for any material.
struct TensileSheet {
  SheetMaterial sheet = {};

  static constexpr std::string_view name = "tensile_sheet";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    SheetMaterial::fields(self.sheet, visit);
  }
};

/// How a builder makes a sheet stiff.
using SheetLaw = std::variant<NaiveSprings, CalibratedSprings, TensileSheet>;

}  // namespace hooke
