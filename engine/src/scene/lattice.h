#pragma once

#include <array>
#include <string_view>
#include <vector>

#include <hooke/scene.h>

namespace hooke {

/// Springs of one kind and direction: from each particle to the one at an offset, where there is one.
struct LatticeSpring {
  std::array<int, 3> offset;  ///< in particles along each axis
  double stiffness;           ///< [N/m]; with zero no springs are made
  double rest_length;         ///< [m]; given, not measured, so that equal springs have equal bits
};

/// A box of evenly spaced particles, numbered along the first axis, then the second, then the third. A cloth
/// is a lattice one particle thick, a rope one that is also one particle wide.
struct Lattice {
  std::array<Index, 3> size;  ///< particles along each axis, >= 1
  Vec3 origin;                ///< [m] of the first particle
  std::array<Vec3, 3> step;   ///< [m] from a particle to the next along each axis
  double cell_mass;           ///< [kg] of what lies between neighbours; particles at an end get half
  std::vector<LatticeSpring> springs;
  double damping;                       ///< of every spring [N s/m]
  double damping_over_stiffness = 0.0;  ///< [s], added to it
  /// Springs are shared by the cells around them: along the rim they have a half, along an edge of a box a
  /// quarter.
  bool springs_of_cells = false;

  /// Number of the particle at (i, j, k), the first being 0.
  Index number(Index i, Index j, Index k) const { return (k * size[1] + j) * size[0] + i; }
};

/// Checks what follows from the parameters of `builder` (which passed their own checks), throws SceneError if
/// the lattice cannot be added, and reserves memory for it and for `triangles` more triangles.
void make_room(Scene& scene, std::string_view builder, const Lattice& lattice, double triangles);

/// Adds particles, and springs in the order of their first particle; returns the first particle's number.
Index add_lattice(Scene& scene, const Lattice& lattice);

}  // namespace hooke
