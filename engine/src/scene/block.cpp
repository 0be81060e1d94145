#include <numbers>
#include <utility>

#include <hooke/builders.h>

#include "scene/element_checks.h"
#include "scene/lattice.h"
#include "scene/placement.h"

namespace hooke {
namespace {

void require_good(const Block& block) {
  std::vector<Fault> faults;
  const ElementChecks checks(faults, Block::name);
  checks.at_least("nx", block.nx, 2);
  checks.at_least("ny", block.ny, 2);
  checks.at_least("nz", block.nz, 2);
  checks.positive("spacing", block.spacing, "m");
  checks.positive("density", block.density, "kg/m^3");
  checks.not_negative("stretch", block.stretch, "N/m");
  checks.not_negative("shear", block.shear, "N/m");
  checks.not_negative("body", block.body, "N/m");
  checks.not_negative("damping", block.damping, "N s/m");
  check_placement(checks, block.placement);
  throw_if_any(std::move(faults));
}

Lattice lattice_of(const Block& block) {
  const Eigen::Affine3d place = to_transform(block.placement);
  const double cell = block.spacing * block.placement.scale;
  const double face = std::numbers::sqrt2 * cell;
  const double body = std::numbers::sqrt3 * cell;
  return {
      .size = {block.nx, block.ny, block.nz},
      .origin = place.translation(),
      .step = {place.linear() * Vec3(block.spacing, 0.0, 0.0), place.linear() * Vec3(0.0, block.spacing, 0.0),
               place.linear() * Vec3(0.0, 0.0, block.spacing)},
      .cell_mass = block.density * cell * cell * cell,
      .springs = {{{1, 0, 0}, block.stretch, cell},
                  {{0, 1, 0}, block.stretch, cell},
                  {{0, 0, 1}, block.stretch, cell},
                  {{1, 1, 0}, block.shear, face},
                  {{-1, 1, 0}, block.shear, face},
                  {{1, 0, 1}, block.shear, face},
                  {{-1, 0, 1}, block.shear, face},
                  {{0, 1, 1}, block.shear, face},
                  {{0, -1, 1}, block.shear, face},
                  {{1, 1, 1}, block.body, body},
                  {{-1, 1, 1}, block.body, body},
                  {{1, -1, 1}, block.body, body},
                  {{-1, -1, 1}, block.body, body}},
      .damping = block.damping};
}

double surface_triangles(const Block& block) {
  const double x = block.nx - 1.0, y = block.ny - 1.0, z = block.nz - 1.0;
  return 4.0 * (x * y + y * z + z * x);
}

/// The two faces across `axis`. Going from u to v turns about +axis, so the far face is counter-clockwise
/// seen from outside, and the near face is the same turned over.
void add_faces(Scene& scene, const Lattice& lattice, Index first, std::size_t axis) {
  const std::size_t u = (axis + 1) % 3;
  const std::size_t v = (axis + 2) % 3;
  for (Index j = 0; j + 1 < lattice.size[v]; ++j) {
    for (Index i = 0; i + 1 < lattice.size[u]; ++i) {
      const auto corner = [&](Index along_axis, Index along_u, Index along_v) {
        std::array<Index, 3> place{};
        place[axis] = along_axis;
        place[u] = along_u;
        place[v] = along_v;
        return first + lattice.number(place[0], place[1], place[2]);
      };
      const Index far = lattice.size[axis] - 1;
      scene.triangles.push_back({corner(far, i, j), corner(far, i + 1, j), corner(far, i + 1, j + 1)});
      scene.triangles.push_back({corner(far, i, j), corner(far, i + 1, j + 1), corner(far, i, j + 1)});
      scene.triangles.push_back({corner(0, i, j), corner(0, i + 1, j + 1), corner(0, i + 1, j)});
      scene.triangles.push_back({corner(0, i, j), corner(0, i, j + 1), corner(0, i + 1, j + 1)});
    }
  }
}

}  // namespace

BlockParticles add(Scene& scene, const Block& block) {
  require_good(block);
  const Lattice lattice = lattice_of(block);
  make_room(scene, Block::name, lattice, surface_triangles(block));
  const Index first = add_lattice(scene, lattice);
  for (std::size_t axis = 0; axis < 3; ++axis) add_faces(scene, lattice, first, axis);
  return {first, block.nx, block.ny, block.nz};
}

}  // namespace hooke
