#include "study/measured_run.h"

#include <algorithm>

#include "study/method_choice.h"
#include "study/position_error.h"

namespace hooke::study {
namespace {

bool has_diverged(const Sample& sample, const ReferenceSolution& reference) {
  // Times the energy scale. Symplectic Euler just below its limit swings by some hundreds of it and stays
  // bounded.
  constexpr double most = 1000.0;
  const double energy = sample.energy.total();
  if (!std::isfinite(energy)) return true;
  const Sample& expected = reference.expected(sample.tick);
  const double scale = std::max(reference.energy_scale, 1e-12 * std::abs(expected.energy.total()));
  return std::abs(energy - expected.energy.total()) > most * scale;
}

MeasuredSample measure(const SampledRun& run, unsigned tick, const ReferenceSolution& reference,
                       std::vector<double>& positions) {
  MeasuredSample measured{run.sample(tick)};
  if (is_output(tick) && tick <= reference.trusted) {
    run.copy_positions(positions);
    const PositionError error =
        position_error(positions, reference.positions[tick], reference.free_particles);
    measured.rms_error = error.rms / reference.scene_size;
    measured.max_error = error.max / reference.scene_size;
  }
  return measured;
}

}  // namespace

const MeasuredSample* MeasuredRun::at(unsigned tick) const {
  const auto is_it = [&](const MeasuredSample& measured) { return measured.sample.tick == tick; };
  const auto found = std::find_if(samples.begin(), samples.end(), is_it);
  return found == samples.end() ? nullptr : &*found;
}

MeasuredRun measure_run(const Scene& scene, const StudySettings& settings, const RunPlan& plan,
                        const ReferenceSolution& reference, unsigned until, double deadline,
                        StudyClock& clock) {
  MeasuredRun result;
  result.plan = plan;
  SampledRun run(scene, settings, plan, clock);
  std::vector<double> positions;
  for (unsigned tick = 0; tick <= until && result.end == RunEnd::reached; ++tick) {
    if (!meets(plan.steps, tick)) continue;
    result.end = run.advance_to(tick, deadline);
    if (result.end == RunEnd::reached) {
      result.samples.push_back(measure(run, tick, reference, positions));
      if (has_diverged(result.samples.back().sample, reference)) result.end = RunEnd::diverged;
    }
  }
  if (result.end == RunEnd::diverged) result.diverged_at = run.time();
  result.choice = choice_of(plan, run, settings);
  result.force_evaluations = run.force_evaluations();
  result.seconds = run.seconds();
  return result;
}

void time_again(const Scene& scene, const StudySettings& settings, const std::vector<unsigned>& ticks,
                double deadline, StudyClock& clock, MeasuredRun& run) {
  SampledRun again(scene, settings, run.plan, clock);
  for (const unsigned tick : ticks) {
    if (again.advance_to(tick, deadline) != RunEnd::reached) return;
    for (MeasuredSample& measured : run.samples) {
      if (measured.sample.tick == tick)
        measured.sample.seconds = std::min(measured.sample.seconds, again.seconds());
    }
  }
  ++run.repeats;
}

}  // namespace hooke::study
