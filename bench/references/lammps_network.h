#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <hooke/scene.h>

namespace hooke::reference {

/// Where LAMMPS and its launcher are.
struct LammpsPrograms {
  std::string lmp, mpirun;
};

/// A network of springs for LAMMPS, which runs as a program of its own: atoms of `atom_style bond` with a
/// mass each, `bond_style harmonic`, no pairs, `fix nve` (velocity Verlet) on what is not pinned, and the
/// scene's gravity and drag as `fix gravity` and `fix viscous`. LAMMPS works in double.
class LammpsNetwork {
 public:
  /// Writes the network into a new folder, which is removed with this object. `step` in [s]. Throws
  /// std::invalid_argument for what LAMMPS has no word for: damped springs, moving pins, other effects.
  LammpsNetwork(LammpsPrograms programs, const Scene& network, double step);
  ~LammpsNetwork();
  LammpsNetwork(const LammpsNetwork&) = delete;
  LammpsNetwork& operator=(const LammpsNetwork&) = delete;

  struct TimedRun {
    std::vector<Vec3> positions;  ///< [m] after the untimed steps
    double energy_change = 0.0;   ///< over the timed steps, against the energy before them
    double seconds = 0.0;         ///< [s] the "Loop time" that LAMMPS gives for the timed steps
  };
  /// Takes `untimed` steps, then `timed` ones, on so many processes. Throws std::runtime_error where LAMMPS
  /// fails.
  TimedRun timed_run(unsigned processes, int untimed, std::uint64_t timed) const;

  struct Frame {
    std::uint64_t step = 0;
    std::vector<Vec3> positions, velocities;  ///< [m], [m/s]
  };
  /// Takes `steps` steps on one process and returns the frames 0, every, 2 every ... All in one run of
  /// LAMMPS: a second one would begin with new forces, of the whole step's velocity. Throws
  /// std::runtime_error where LAMMPS fails.
  std::vector<Frame> frames(std::uint64_t steps, std::uint64_t every) const;

 private:
  /// Runs the network's commands and then these. Returns LAMMPS' log.
  std::string run(unsigned processes, const std::string& commands) const;
  std::vector<Frame> read_dump() const;

  LammpsPrograms programs_;
  std::filesystem::path folder_;
  std::size_t particles_;
  std::string setup_;  ///< the commands that read the network and say how it moves
};

}  // namespace hooke::reference
