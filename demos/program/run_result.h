#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <hooke/report.h>

namespace hooke::program {

/// Time that a sweep of the plan took over a run.
struct SweepSeconds {
  std::string sweep;
  double seconds = 0.0;  ///< [s]
};

/// What a run did: all that its summary and its report say.
struct RunResult {
  std::string scene;  ///< the scene's name, or its file's where it has none
  std::size_t particles = 0, springs = 0;
  std::string method, accumulation, precision;
  unsigned threads = 0;
  double step = 0.0;           ///< [s]
  std::uint64_t substeps = 1;  ///< equal parts that each step is taken in

  std::uint64_t steps = 0;  ///< good steps taken
  std::uint64_t force_evaluations = 0;
  std::uint64_t rejected_steps = 0;     ///< that error control took again
  std::uint64_t solver_iterations = 0;  ///< of a method that solves equations
  std::uint64_t linear_iterations = 0;  ///< of the linear solver within those
  double residual = 0.0;                ///< see Report [1]
  double simulated_seconds = 0.0;       ///< [s]
  double wall_seconds = 0.0;            ///< [s] spent in steps alone
  double compile_seconds = 0.0;         ///< [s] spent on making the simulation of the scene
  double total_wall_seconds = 0.0;      ///< [s] of the whole run, with reading and writing
  std::vector<SweepSeconds> sweeps;     ///< of the plan

  double energy_start = 0.0, energy_end = 0.0;  ///< [J]
  double max_strain = 0.0;                      ///< [1] largest of the states that were frames, and the last
  double max_strain_end = 0.0;                  ///< [1] of the last state
  std::size_t frames = 0;
  std::uint64_t state_hash = 0;  ///< of the last good state

  std::uint32_t flags = flag_none;
  Index first_bad_particle = Report::none;
  std::uint64_t bad_step = 0;  ///< number of the step that went bad; 0: none did
  std::string message;         ///< what went wrong last, or was put right; empty where nothing did
  int interrupted_by = 0;      ///< number of a signal; 0: none came

  std::size_t simulation_bytes = 0;   ///< held by the simulation
  std::size_t peak_memory_bytes = 0;  ///< of the process

  std::filesystem::path out;    ///< folder of the frames; empty where none were asked for
  std::filesystem::path entry;  ///< the file to open to see the run
  std::vector<std::filesystem::path> files;

  std::vector<std::filesystem::path> pictures;  ///< files of pictures and movies
  std::string pictures_driver;                  ///< what drew them; empty where none were asked for
  std::string pictures_problem;                 ///< why some of them are missing; empty where none are
  double pictures_seconds = 0.0;                ///< [s] spent on drawing them, after the run

  /// Wall time [ns] for each spring and step, and for each particle and step; a part of a step counts as one.
  /// Nothing where there are none.
  std::optional<double> ns_per_spring_step() const;
  std::optional<double> ns_per_particle_step() const;
};

}  // namespace hooke::program
