#include <numbers>
#include <utility>

#include <hooke/builders.h>

#include "scene/element_checks.h"
#include "scene/lattice.h"
#include "scene/placement.h"

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
  check_placement(checks, cloth.placement);
  throw_if_any(std::move(faults));
}

Lattice lattice_of(const ClothGrid& cloth) {
  const Eigen::Affine3d place = to_transform(cloth.placement);
  const double cell = cloth.spacing * cloth.placement.scale;
  const double diagonal = std::numbers::sqrt2 * cell;
  return {.size = {cloth.columns, cloth.rows, 1},
          .origin = place.translation(),
          .step = {place.linear() * Vec3(cloth.spacing, 0.0, 0.0),
                   place.linear() * Vec3(0.0, -cloth.spacing, 0.0), Vec3::Zero()},
          .cell_mass = cloth.areal_density * cell * cell,
          .springs = {{{1, 0, 0}, cloth.stretch, cell},
                      {{0, 1, 0}, cloth.stretch, cell},
                      {{1, 1, 0}, cloth.shear, diagonal},
                      {{-1, 1, 0}, cloth.shear, diagonal},
                      {{2, 0, 0}, cloth.bend, 2.0 * cell},
                      {{0, 2, 0}, cloth.bend, 2.0 * cell}},
          .damping = cloth.damping};
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
  add_triangles(scene, grid);
  return grid;
}

}  // namespace hooke
