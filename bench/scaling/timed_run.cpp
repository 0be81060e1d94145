#include "scaling/timed_run.h"

#include <algorithm>
#include <cmath>

#include "program/stopwatch.h"

namespace hooke::bench {
namespace {

std::variant<Simulation<float>, Simulation<double>> compile(const BenchScene& bench,
                                                            const Configuration& configuration) {
  const Settings settings{.step = bench.step,
                          .unstable_step = UnstableStep::take,
                          .accumulation = configuration.mode,
                          .threads = configuration.threads};
  if (configuration.precision == program::Precision::single) return Simulation<float>(bench.scene, settings);
  return Simulation<double>(bench.scene, settings);
}

}  // namespace

TimedRun::TimedRun(const BenchScene& bench, const ReferenceCheck& check, const Configuration& configuration,
                   double seconds)
    : check_(check), configuration_(configuration), simulation_(compile(bench, configuration)) {
  std::visit(
      [&](auto& simulation) {
        cost_ = step_cost(simulation);
        good_ = check.agrees(simulation);
        energy_before_ = simulation.energy().total();
      },
      simulation_);
  fill_repetition(seconds);
}

double TimedRun::seconds_of(std::uint64_t steps) {
  return std::visit(
      [&](auto& simulation) {
        const program::Stopwatch watch;
        const Report report = simulation.step(steps);
        const double seconds = watch.seconds();
        good_ = good_ && report.ok();
        return seconds;
      },
      simulation_);
}

void TimedRun::fill_repetition(double seconds) {
  double taken = seconds_of(steps_);
  while (taken < seconds / 4 && good_) {
    steps_ *= 2;
    taken = seconds_of(steps_);
  }
  // A tenth more, as the first steps are often the slowest.
  steps_ = std::max<std::uint64_t>(1, std::uint64_t(std::ceil(1.1 * seconds / taken * double(steps_))));
}

void TimedRun::repeat() {
  if (steps_ > 1) seconds_of((steps_ + 9) / 10);
  seconds_per_step_.push_back(seconds_of(steps_) / double(steps_));
  std::visit(
      [&](auto& simulation) {
        good_ = good_ && check_.stayed_good(simulation, simulation.step(), energy_before_);
      },
      simulation_);
}

}  // namespace hooke::bench
