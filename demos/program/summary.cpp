#include "program/summary.h"

#include <algorithm>
#include <ostream>

#include "program/rounded.h"

namespace hooke::program {
namespace {

std::string speed(const RunResult& result) {
  if (const auto ns = result.ns_per_spring_step()) return rounded(*ns) + " ns for each spring and step";
  if (const auto ns = result.ns_per_particle_step())
    return rounded(*ns) + " ns for each particle and step (no springs)";
  return "no steps were taken";
}

std::string mebibytes(std::size_t bytes) {
  return rounded(static_cast<double>(bytes) / (1024.0 * 1024.0)) + " MiB";
}

std::string bytes_of_each(std::size_t bytes, std::size_t particles) {
  return std::to_string(particles == 0 ? 0 : bytes / particles) + " bytes";
}

/// Of a method that solves equations.
void print_iterations(const RunResult& result, std::ostream& out) {
  if (result.solver_iterations == 0) return;
  const double steps = std::max(1.0, double(result.steps));
  out << "  equations        " << rounded(double(result.solver_iterations) / steps) << " iterations a step";
  if (result.linear_iterations > 0)
    out << ", " << rounded(double(result.linear_iterations) / steps) << " of the linear solver";
  out << "; the last ones moved particles by at most " << rounded(result.residual)
      << " of the scene's size\n";
}

void print_files(const RunResult& result, std::ostream& out) {
  out << "  files written    ";
  if (result.out.empty()) {
    out << "none (--out DIR writes frames)\n";
  } else {
    out << result.files.size() << " in " << result.out.string() << ", to open: " << result.entry.string()
        << '\n';
  }
}

void print_pictures(const RunResult& result, std::ostream& out) {
  if (result.pictures_driver.empty()) return;
  out << "  pictures         ";
  for (const std::filesystem::path& file : result.pictures)
    out << (&file == &result.pictures.front() ? "" : ", ") << file.string();
  out << (result.pictures.empty() ? "none" : "") << "; drawn in " << rounded(result.pictures_seconds)
      << " s by " << result.pictures_driver << '\n';
}

}  // namespace

void print_summary(const RunResult& result, std::ostream& out) {
  out << result.scene << ": " << result.particles << " particles, " << result.springs << " springs; "
      << result.method << ", " << result.accumulation << ", " << result.precision << ", " << result.threads
      << (result.threads == 1 ? " thread\n" : " threads\n");
  if (result.interrupted_by != 0) out << "  interrupted; what follows is of the run so far\n";
  out << "  steps            " << result.steps << " of " << rounded(result.step)
      << (result.substeps > 1 ? " s, each in " + std::to_string(result.substeps) + " parts" : " s") << ": "
      << result.simulated_seconds << " s simulated, " << result.force_evaluations << " evaluations of forces";
  if (result.rejected_steps > 0)
    out << ", " << result.rejected_steps
        << (result.rejected_steps == 1 ? " step taken again" : " steps taken again");
  out << '\n';
  print_iterations(result, out);
  out << "  wall time        " << rounded(result.wall_seconds) << " s in steps, "
      << rounded(result.compile_seconds) << " s to compile the scene, " << rounded(result.total_wall_seconds)
      << " s in all\n";
  out << "  speed            " << speed(result) << '\n';
  out << "  energy           " << result.energy_start << " J at the start, " << result.energy_end
      << " J at the end\n";
  out << "  largest strain   " << rounded(100.0 * result.max_strain) << " % in " << result.frames
      << " frames, " << rounded(100.0 * result.max_strain_end) << " % at the end\n";
  out << "  memory           " << bytes_of_each(result.simulation_bytes, result.particles)
      << " for each particle in the simulation; peak of the process " << mebibytes(result.peak_memory_bytes)
      << ", " << bytes_of_each(result.peak_memory_bytes, result.particles) << " for each particle\n";
  print_files(result, out);
  print_pictures(result, out);
}

}  // namespace hooke::program
