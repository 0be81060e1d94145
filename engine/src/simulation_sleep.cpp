// Steps of a scene of which parts may sleep.

#include <algorithm>
#include <chrono>

#include "report_of_steps.h"
#include "simulation_parts.h"
#include "step.h"

namespace hooke {
namespace {

constexpr std::string_view sweep_name = "sleep";

}  // namespace

template <class Real>
void Simulation<Real>::Parts::begin_sleep(const Sleep& sleep) {
  sleepers.emplace(sleep, model, settings.step);
  show_between_steps({std::string(Sleep::name),
                      std::string(sweep_name),
                      {"position", "velocity"},
                      {"blocks of particles that steps work on"},
                      sleepers->bytes()},
                     sweep_name);
}

template <class Real>
void Simulation<Real>::Parts::follow_sleepers() {
  if (!model.follow_islands()) return;
  std::vector<std::size_t> awake;
  for (std::size_t tile = 0; tile < plan.tiles.count(); ++tile) {
    if (model.awake.any(plan.tiles.begin(tile), plan.tiles.end(tile))) awake.push_back(tile);
  }
  workers.choose(std::move(awake));
  for (State<Real>& state : between) state = states.now();  // where sleepers are felt
  forces.clear();                                           // of sums that blocks asleep did not take
  whole.forget();
  if (controlled) controlled->restart(controlled->next_step(), controlled->last_error());
}

template <class Real>
void Simulation<Real>::Parts::wake(std::span<const Index> particles) {
  if (!sleepers) return;
  sleepers->wake(particles);
  follow_sleepers();
}

template <class Real>
bool Simulation<Real>::Parts::wake_met() {
  if (!sleepers || !sleepers->wake_touched()) return false;
  model.islands->forget_touches();
  follow_sleepers();
  return true;
}

template <class Real>
void Simulation<Real>::Parts::take_sleeping_steps(std::uint64_t count, Report& report) {
  using WallClock = std::chrono::steady_clock;
  while (report.steps_taken < count && report.ok()) {
    WallClock::time_point start = WallClock::now();
    const auto lap = [&] {
      time_of(sweep_name).seconds += std::chrono::duration<double>(WallClock::now() - start).count();
    };
    const double end = StepTimes{time_at_step_0, steps, settings.step}.after(1);
    sleepers->begin_step(states.now().time, end, forces.effects());
    follow_sleepers();
    lap();
    if (model.islands->asleep() == model.islands->size()) {
      rest_until(end);
      ++report.steps_taken;
      continue;
    }
    Report step;
    take_awake_steps(1, step);
    add_step(step, report);
    if (!step.ok()) break;
    start = WallClock::now();
    forces.effects().note_touches(states.now(), *executor, *model.islands);
    sleepers->end_step(states, *executor);
    follow_sleepers();
    lap();
  }
}

/// A step in which nothing is awake.
template <class Real>
void Simulation<Real>::Parts::rest_until(double time) {
  states.now().time = time;
  whole.forget();
  ++steps;
}

template struct Simulation<float>::Parts;
template struct Simulation<double>::Parts;

}  // namespace hooke
