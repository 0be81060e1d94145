#include "program/run_result.h"

namespace hooke::program {
namespace {

std::optional<double> ns_per_step_of_each(double seconds, std::uint64_t steps, std::size_t elements) {
  if (steps == 0 || elements == 0) return std::nullopt;
  return seconds * 1e9 / static_cast<double>(steps) / static_cast<double>(elements);
}

}  // namespace

std::optional<double> RunResult::ns_per_spring_step() const {
  return ns_per_step_of_each(wall_seconds, steps * substeps, springs);
}

std::optional<double> RunResult::ns_per_particle_step() const {
  return ns_per_step_of_each(wall_seconds, steps * substeps, particles);
}

}  // namespace hooke::program
