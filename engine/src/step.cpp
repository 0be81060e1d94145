// Start here: a step of a simulation is the stages of its method, each of which runs the sweeps of the plan,
// one after the other. Where all is one sweep over the blocks, many steps are run at once, tile by tile.

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

/// The substeps of a few steps, numbered through, and the states that they go through.
template <class Real>
class Substeps {
 public:
  Substeps(const PlanRun<Real>& run, const StepTimes& times, std::size_t first, StateRing<Real>& states,
           std::atomic<Index>& first_bad)
      : run_(run), times_(times), first_(first), states_(states), first_bad_(first_bad) {}

  Substep<Real> operator[](std::size_t number) const {
    const std::size_t stages = run_.plan.stages, step = number / stages, stage = number % stages;
    const Scheme<Real>& scheme = run_.scheme;
    State<Real>& start = states_.after(first_ + step);
    State<Real>& now = stage == 0 ? start : between(stage - 1);
    const bool last = stage + 1 == stages;
    State<Real>& next = last ? states_.after(first_ + step + 1) : between(stage);
    const double pending = step == 0 ? start.pending_kick : scheme.last_kick() * times_.h();
    const double time = times_.after(step, scheme.time(stage));
    const double time_after = last ? times_.after(step + 1) : times_.after(step, scheme.time(stage + 1));
    return {stage, start, now, next, times_.h(), stage == 0 ? pending : 0.0, time, time_after, first_bad_};
  }

 private:
  State<Real>& between(std::size_t stage) const { return run_.between[stage % run_.between.size()]; }

  const PlanRun<Real>& run_;
  const StepTimes& times_;
  std::size_t first_;
  StateRing<Real>& states_;
  std::atomic<Index>& first_bad_;
};

template <class Real>
void run_tiles(const PlanRun<Real>& run, const Sweep<Real>& sweep, const Substeps<Real>& substeps,
               std::size_t first, std::size_t count) {
  run.workers.run(run.executor, count, [&](std::size_t n, std::size_t begin, std::size_t end) {
    sweep.run_blocks(substeps[first + n], begin, end);
  });
}

/// How many substeps may run at once from one on, of `all`. What the host's move brings to a place within a
/// step rests there in the next one, so no run goes past its end.
template <class Real>
std::size_t at_once_from(std::size_t n, std::size_t all, const PlanRun<Real>& run, const StepTimes& times) {
  const std::size_t stages = run.plan.stages, step = n / stages;
  Frames* const frames = run.plan.frames;
  if (frames != nullptr && n % stages == 0) frames->begin_step(times.after(step));
  if (!run.plan.tiled) return 1;
  if (frames == nullptr) return all - n;
  const double end = frames->end_of_moves();
  std::size_t steps = 1;
  while ((step + steps) * stages < all && times.after(step + steps) < end) ++steps;
  return steps * stages;
}

}  // namespace

template <class Real>
Index take_steps(const PlanRun<Real>& run, const StepTimes& times, std::size_t first, std::size_t count,
                 StateRing<Real>& states) {
  std::atomic<Index> first_bad{Report::none};
  const Substeps<Real> substeps(run, times, first, states, first_bad);
  const std::size_t all = count * run.plan.stages;
  Stopwatch stopwatch;
  for (std::size_t n = 0, at_once = 0; n < all; n += at_once) {
    at_once = at_once_from(n, all, run, times);
    for (std::size_t i = 0; i < run.plan.sweeps.size(); ++i) {
      const Sweep<Real>& sweep = run.plan.sweeps[i];
      if (sweep.run_all) {
        sweep.run_all(substeps[n], run.executor);
      } else {
        run_tiles(run, sweep, substeps, n, at_once);
      }
      stopwatch.lap(run.times[i]);
    }
  }
  if (first_bad != Report::none) return first_bad;
  for (std::size_t n = 1; n <= count; ++n) {
    states.after(first + n).time = times.after(n);
    states.after(first + n).pending_kick = run.scheme.last_kick() * times.h();
  }
  return Report::none;
}

template Index take_steps(const PlanRun<float>&, const StepTimes&, std::size_t, std::size_t,
                          StateRing<float>&);
template Index take_steps(const PlanRun<double>&, const StepTimes&, std::size_t, std::size_t,
                          StateRing<double>&);

}  // namespace hooke
