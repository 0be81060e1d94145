#pragma once

#include <ostream>

#include <hooke/scene.h>

namespace hooke::reference {

/// Writes a network of springs as a data file of LAMMPS' `atom_style bond` with a mass for each atom, in full
/// precision. Atoms of type 1 are free, those of type 2 pinned. Throws std::invalid_argument for what a
/// harmonic bond of LAMMPS is not: a damped spring, a pin that moves.
void write_lammps_data(std::ostream& data, const Scene& network);

}  // namespace hooke::reference
