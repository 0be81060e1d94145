// Start here: a step of a simulation is the sweeps of its plan, one after the other, from the state now to
// the next one. Where all is one sweep over the blocks, many steps are run at once, tile by tile.

#include "step.h"

#include <chrono>

namespace hooke {
namespace {

/// Adds the time since it was made, or since the last lap, to a sweep.
class Stopwatch {
 public:
  void lap(SweepTime& time) {
    const auto now = Time::now();
    time.seconds += std::chrono::duration<double>(now - before_).count();
    before_ = now;
  }

 private:
  using Time = std::chrono::steady_clock;
  Time::time_point before_ = Time::now();
};

template <class Real>
void run_tiles(const PlanRun<Real>& run, const Sweep<Real>& sweep, const StepTimes& times, std::size_t count,
               StateRing<Real>& states, std::atomic<Index>& first_bad) {
  run.workers.run(run.executor, count, [&](std::size_t n, std::size_t begin, std::size_t end) {
    const Step<Real> step{states.after(n), states.after(n + 1), times.h,
                          times.after(n),  times.after(n + 1),  first_bad};
    sweep.run_blocks(step, begin, end);
  });
}

}  // namespace

template <class Real>
Index take_steps(const PlanRun<Real>& run, const StepTimes& times, std::size_t count,
                 StateRing<Real>& states) {
  std::atomic<Index> first_bad{Report::none};
  Stopwatch stopwatch;
  for (std::size_t i = 0; i < run.plan.sweeps.size(); ++i) {
    const Sweep<Real>& sweep = run.plan.sweeps[i];
    if (sweep.run_all) {
      const Step<Real> step{states.after(0), states.after(1), times.h,
                            times.after(0),  times.after(1),  first_bad};
      sweep.run_all(step, run.executor);
    } else {
      run_tiles(run, sweep, times, count, states, first_bad);
    }
    stopwatch.lap(run.times[i]);
  }
  if (first_bad != Report::none) {
    states.drop();
    return first_bad;
  }
  for (std::size_t n = 1; n <= count; ++n) states.after(n).time = times.after(n);
  states.advance(count);
  return Report::none;
}

template Index take_steps(const PlanRun<float>&, const StepTimes&, std::size_t, StateRing<float>&);
template Index take_steps(const PlanRun<double>&, const StepTimes&, std::size_t, StateRing<double>&);

}  // namespace hooke
