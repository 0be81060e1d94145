#include "report_of_steps.h"

#include <algorithm>

namespace hooke {

void add_step(const Report& step, Report& report) {
  const std::uint64_t back = std::min(report.steps_taken, step.steps_undone);
  report.steps_taken += step.steps_taken - back;
  report.steps_undone += step.steps_undone - back;
  report.force_evaluations += step.force_evaluations;
  report.rejected_steps += step.rejected_steps;
  report.solver_iterations += step.solver_iterations;
  report.linear_iterations += step.linear_iterations;
  report.residual = std::max(report.residual, step.residual);
  report.flags |= step.flags;
  constexpr std::uint32_t trouble = flag_not_finite | flag_step_too_small | flag_energy_grew | flag_restored;
  if ((step.flags & trouble) == 0) return;
  report.step = step.step;
  report.first_bad_particle = step.first_bad_particle;
  report.strained_spring = step.strained_spring;
  report.kinetic_energy = step.kinetic_energy;
  report.energy_put_in = step.energy_put_in;
}

}  // namespace hooke
