#pragma once

#include <filesystem>
#include <vector>

#include <hooke/scene.h>

namespace hooke::bench {

/// A sheet of 1 m, hung level by two corners, that falls into the vertical and settles.
struct HungSheet {
  Index particles_a_side = 0;
  Scene scene;

  /// Structural and shear springs are in the plane of the sheet and say how far it is stretched; bend
  /// springs, of twice the spacing, are not.
  bool in_plane(std::size_t spring) const;
};

/// The rate at which drag takes velocities away [1/s], at an inner particle.
constexpr double drag_rate = 2.0;

/// With the stiffest springs that symplectic Euler bears with steps of `step` [s]: h w = 1.8 of the 2 that
/// are stable, w by the edge bound. Structural, shear and bend springs are as 100 to 50 to 1.
HungSheet hung_sheet(Index particles_a_side, double step);

/// |l - l0| / l0 over the springs in the plane [1].
struct Strain {
  double largest = 0.0, percentile_99 = 0.0, median = 0.0;
};

Strain strain_of(const HungSheet& sheet, const std::vector<Vec3>& positions);

/// Writes x, y, z of each particle [m], a line each, with an empty line after each row of the sheet.
void write_points(const std::filesystem::path& file, const HungSheet& sheet,
                  const std::vector<Vec3>& positions);

}  // namespace hooke::bench
