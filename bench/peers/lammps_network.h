#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <hooke/scene.h>

#include "peer.h"

namespace hooke::bench {

/// Where LAMMPS and its launcher are.
struct LammpsPrograms {
  std::string lmp, mpirun;
};

/// A network of springs for LAMMPS, which runs as a program of its own: atoms of `atom_style bond` with a
/// mass each, `bond_style harmonic`, no pairs, `fix nve` (velocity Verlet) on what is not pinned. LAMMPS
/// works in double.
class LammpsNetwork {
 public:
  /// Writes the network into a new folder, which is removed with this object.
  LammpsNetwork(LammpsPrograms programs, const Scene& network, double step);
  ~LammpsNetwork();
  LammpsNetwork(const LammpsNetwork&) = delete;
  LammpsNetwork& operator=(const LammpsNetwork&) = delete;

  struct Run {
    std::vector<Vec3> positions;  ///< [m] after the untimed steps
    double energy_change = 0.0;   ///< over the timed steps, against the energy before them
    double seconds = 0.0;         ///< [s] the "Loop time" that LAMMPS gives for the timed steps
  };
  /// Takes `untimed` steps, then `timed` ones, on so many processes. Throws std::runtime_error where LAMMPS
  /// fails.
  Run run(unsigned processes, int untimed, std::uint64_t timed) const;

 private:
  void write_data(const Scene& network) const;
  void write_script(const Scene& network, double step) const;
  std::vector<Vec3> read_positions() const;

  LammpsPrograms programs_;
  std::filesystem::path folder_;
  std::size_t particles_;
};

}  // namespace hooke::bench
