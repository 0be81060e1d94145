#include "study/sampled_run.h"

#include <algorithm>
#include <chrono>

namespace hooke::study {
namespace {

Settings settings_of(const StudySettings& settings, const RunPlan& plan) {
  Settings result;
  result.method = plan.method;
  result.step = settings.horizon / double(plan.steps);
  result.unstable_step = UnstableStep::take;  // how a method fails is part of what is studied
  if (can_accumulate(plan.method, settings.accumulation)) result.accumulation = settings.accumulation;
  result.executor = settings.executor;
  return result;
}

}  // namespace

SampledRun::SampledRun(const Scene& scene, const StudySettings& settings, const RunPlan& plan,
                       StudyClock& clock)
    : simulation_(scene, settings_of(settings, plan)),
      particles_(scene.particles.size()),
      steps_to_horizon_(plan.steps),
      clock_(clock) {}

/// About 0.05 s of steps; at first one, as nothing is known.
std::uint64_t SampledRun::steps_until_look() const {
  constexpr double look_every = 0.05;  // [s]
  const double taken = double(simulation_.steps());
  if (taken == 0.0) return 1;
  const double affordable = look_every * taken / std::max(seconds_, 1e-9);
  return std::uint64_t(std::clamp(affordable, 1.0, 4.0 * taken));
}

RunEnd SampledRun::advance_to(unsigned tick, double deadline) {
  const std::uint64_t goal = steps_to_horizon_ * tick / last_tick;
  while (simulation_.steps() < goal) {
    if (!clock_.go_on()) return RunEnd::stopped;
    if (clock_.elapsed() > deadline) return RunEnd::out_of_time;
    const std::uint64_t count = std::min(goal - simulation_.steps(), steps_until_look());
    const auto start = std::chrono::steady_clock::now();
    const Report report = simulation_.step(count);
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    force_evaluations_ += report.force_evaluations;
    if (!report.ok()) return RunEnd::diverged;
  }
  return RunEnd::reached;
}

Sample SampledRun::sample(unsigned tick) const {
  return {tick, simulation_.energy(), simulation_.momentum(), seconds_, force_evaluations_};
}

void SampledRun::copy_positions(std::vector<double>& positions) const {
  positions.resize(3 * simulation_.particle_count());
  simulation_.copy_positions(positions.data(), 3 * sizeof(double));
  positions.resize(3 * particles_);
}

}  // namespace hooke::study
