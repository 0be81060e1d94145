#include <cmath>
#include <numbers>
#include <utility>

#include <hooke/builders.h>

#include "scene/element_checks.h"
#include "scene/lattice.h"
#include "scene/number_text.h"
#include "scene/placement.h"
#include "scene/sheet_law.h"

namespace hooke {
namespace {

void require_good(const ClothGrid& cloth) {
  std::vector<Fault> faults;
  const ElementChecks checks(faults, ClothGrid::name);
  checks.at_least("columns", cloth.columns, 2);
  checks.at_least("rows", cloth.rows, 2);
  checks.positive("spacing", cloth.spacing, "m");
  checks.positive("areal_density", cloth.areal_density, "kg/m^2");
  checks.not_negative("stretch", cloth.stretch, "N/m");
  checks.not_negative("shear", cloth.shear, "N/m");
  checks.not_negative("bend", cloth.bend, "N/m");
  checks.not_negative("damping", cloth.damping, "N s/m");
  check_law(checks, cloth.law);
  if (const auto* springs = std::get_if<CalibratedSprings>(&cloth.law)) {
    const double nu = springs->sheet.poisson_ratio;
    if (std::abs(nu - 1.0 / 3.0) > 1e-3)
      checks.add("law.poisson_ratio is " + to_text(nu) + ", and that of a square grid of springs is 1/3",
                 "give 1/3, or the law tensile_sheet");
  }
  check_placement(checks, cloth.placement);
  throw_if_any(std::move(faults));
}

/// The springs of a law: stretch along rows and columns, shear along diagonals, bend to second neighbours.
struct GridSprings {
  double stretch, shear, bend, damping, damping_over_stiffness;
};

GridSprings springs_of(const ClothGrid& cloth) {
  if (std::holds_alternative<TensileSheet>(cloth.law)) return {};
  if (const auto* springs = std::get_if<CalibratedSprings>(&cloth.law)) {
    const double modulus = springs->sheet.modulus;
    return {0.75 * modulus, 0.375 * modulus, 0.0, 0.0, springs->sheet.damping};
  }
  return {cloth.stretch, cloth.shear, cloth.bend, cloth.damping, 0.0};
}

Lattice lattice_of(const ClothGrid& cloth) {
  const auto [stretch, shear, bend, damping, damping_over_stiffness] = springs_of(cloth);
  const Eigen::Affine3d place = to_transform(cloth.placement);
  const double cell = cloth.spacing * cloth.placement.scale;
  const double diagonal = std::numbers::sqrt2 * cell;
  return {.size = {cloth.columns, cloth.rows, 1},
          .origin = place.translation(),
          .step = {place.linear() * Vec3(cloth.spacing, 0.0, 0.0),
                   place.linear() * Vec3(0.0, -cloth.spacing, 0.0), Vec3::Zero()},
          .cell_mass = areal_density_of(cloth) * cell * cell,
          .springs = {{{1, 0, 0}, stretch, cell},
                      {{0, 1, 0}, stretch, cell},
                      {{1, 1, 0}, shear, diagonal},
                      {{-1, 1, 0}, shear, diagonal},
                      {{2, 0, 0}, bend, 2.0 * cell},
                      {{0, 2, 0}, bend, 2.0 * cell}},
          .damping = damping,
          .damping_over_stiffness = damping_over_stiffness,
          .springs_of_cells = std::holds_alternative<CalibratedSprings>(cloth.law)};
}

/// Two for each cell, counter-clockwise seen from +z.
void add_triangles(Scene& scene, const GridParticles& grid) {
  for (Index row = 0; row + 1 < grid.rows; ++row) {
    for (Index column = 0; column + 1 < grid.columns; ++column) {
      const Index upper_left = grid.at(column, row);
      const Index upper_right = grid.at(column + 1, row);
      const Index lower_left = grid.at(column, row + 1);
      const Index lower_right = grid.at(column + 1, row + 1);
      scene.triangles.push_back({upper_left, lower_left, upper_right});
      scene.triangles.push_back({upper_right, lower_left, lower_right});
    }
  }
}

}  // namespace

GridParticles add(Scene& scene, const ClothGrid& cloth) {
  require_good(cloth);
  const Lattice lattice = lattice_of(cloth);
  make_room(scene, ClothGrid::name, lattice, 2.0 * (cloth.columns - 1.0) * (cloth.rows - 1.0));
  const GridParticles grid{add_lattice(scene, lattice), cloth.columns, cloth.rows};
  const std::size_t first_triangle = scene.triangles.size();
  add_triangles(scene, grid);
  add_tensile_sheet(scene, cloth.law, first_triangle);
  if (const double stiffness = bending_stiffness_of(cloth.law); stiffness > 0.0)
    scene.effects.emplace_back(bending_of(grid, cloth.spacing * cloth.placement.scale, stiffness));
  return grid;
}

}  // namespace hooke
