#include "program/simulate.h"

#include <algorithm>
#include <cstdint>
#include <span>

#include "program/stopwatch.h"

namespace hooke::program {
namespace {

/// How many steps to take before the next look at Ctrl-C and the progress bar: about 0.1 s of them. A first,
/// slow step says little, so it is never more than were taken so far.
std::uint64_t steps_until_look(const RunResult& result) {
  constexpr double seconds = 0.1;
  const double affordable = seconds / result.wall_seconds * static_cast<double>(result.steps);
  const double most = std::min(affordable, static_cast<double>(result.steps));
  return most >= 1.0 ? static_cast<std::uint64_t>(most) : 1;
}

void add(std::span<const SweepTime> times, std::vector<SweepSeconds>& sums) {
  for (const SweepTime& time : times) {
    const auto has_name = [&](const SweepSeconds& sum) { return sum.sweep == time.sweep; };
    const auto sum = std::find_if(sums.begin(), sums.end(), has_name);
    if (sum == sums.end()) {
      sums.push_back({std::string(time.sweep), time.seconds});
    } else {
      sum->seconds += time.seconds;
    }
  }
}

/// Takes steps; false where one went bad.
template <class Real>
bool take_steps(Simulation<Real>& simulation, std::uint64_t count, RunResult& result) {
  const Stopwatch stopwatch;
  const Report report = simulation.step(count);
  result.wall_seconds += stopwatch.seconds();
  result.steps = simulation.steps();
  result.force_evaluations += report.force_evaluations;
  result.rejected_steps += report.rejected_steps;
  result.solver_iterations += report.solver_iterations;
  result.linear_iterations += report.linear_iterations;
  result.residual = std::max(result.residual, report.residual);
  add(report.sweeps, result.sweeps);
  result.flags |= report.flags;
  if (!report.ok() || (report.flags & (flag_energy_grew | flag_step_halved | flag_not_converged)))
    result.message = report.message();
  if (report.ok()) return true;
  result.bad_step = report.step;
  result.first_bad_particle = report.first_bad_particle;
  return false;
}

}  // namespace

template <class Real>
void simulate(Simulation<Real>& simulation, const FrameSchedule& schedule, const Interruption& interruption,
              FrameRecorder<Real>& recorder, std::span<Film> films, ProgressBar& progress,
              RunResult& result) {
  result.energy_start = simulation.energy().total();
  recorder.record(simulation);
  for (Film& film : films) film.follow(simulation);
  bool good = true;
  while (good && simulation.steps() < schedule.steps() && interruption.signal() == 0) {
    const std::uint64_t frame_step = schedule.step_of(recorder.frames());
    std::uint64_t stop = std::min(frame_step, schedule.steps());
    for (const Film& film : films) stop = std::min(stop, film.next_step());
    const std::uint64_t to_go = stop - simulation.steps();
    good = take_steps(simulation, std::min(to_go, steps_until_look(result)), result);
    if (simulation.steps() == frame_step) recorder.record(simulation);
    for (Film& film : films) film.follow(simulation);
    progress.update(static_cast<double>(simulation.steps()) / static_cast<double>(schedule.steps()));
  }
  if (!good && recorder.last_step() < simulation.steps()) recorder.record(simulation);
  for (Film& film : films) film.end(simulation);
  result.interrupted_by = interruption.signal();
  result.simulated_seconds = simulation.time();
  result.energy_end = simulation.energy().total();
  result.max_strain_end = simulation.max_strain();
  result.max_strain = std::max(recorder.max_strain(), result.max_strain_end);
  result.frames = recorder.frames();
  result.state_hash = simulation.state_hash();
}

template void simulate(Simulation<float>&, const FrameSchedule&, const Interruption&, FrameRecorder<float>&,
                       std::span<Film>, ProgressBar&, RunResult&);
template void simulate(Simulation<double>&, const FrameSchedule&, const Interruption&, FrameRecorder<double>&,
                       std::span<Film>, ProgressBar&, RunResult&);

}  // namespace hooke::program
