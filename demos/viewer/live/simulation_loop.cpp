#include "viewer/live/simulation_loop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <utility>
#include <variant>

#include <time.h>

namespace hooke::viewer {
namespace {

double wall_time() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// What something takes [s], by what it took before and took now. One time that was interrupted says little,
/// so it counts for twice as much as before at most.
double usual_cost(double before, double now) {
  return before > 0.0 ? std::min(now, 2.0 * before) : now;
}

/// Time [s] that this thread has had of a processor, so that others' work is not counted for its own.
double thread_time() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// The names of a plan's sweeps, in their order.
std::vector<std::string> sweeps_of(const Plan& plan) {
  std::vector<std::string> names;
  for (const Stage& stage : plan.stages) {
    if (names.empty() || names.back() != stage.sweep) names.push_back(stage.sweep);
  }
  return names;
}

}  // namespace

template <class Real>
SimulationLoop<Real>::SimulationLoop(Scene scene, Settings settings, const Rhythm& rhythm,
                                     CommandQueue& commands, TripleBuffer<Moment>& moments)
    : rhythm_(rhythm), commands_(commands), moments_(moments), live_(std::move(scene), std::move(settings)) {
  describe();
  publish(wall_time());
}

template <class Real>
void SimulationLoop<Real>::run() {
  while (!commands_.closed()) {
    for (const Command& command : commands_.take(idle_seconds(wall_time()))) obey(command);
    if (change_wanted_) change(std::exchange(wanted_, {}));
    if (now_.running) take_due_steps(wall_time());
    publish_if_due();
  }
}

/// How long nothing has to be done unless a command comes.
template <class Real>
double SimulationLoop<Real>::idle_seconds(double now) const {
  double idle = std::numeric_limits<double>::infinity();
  if (changed_ || !measured_) idle = std::max(0.0, next_publishing() - now);
  if (now_.running) idle = std::min(idle, seconds_to_next_steps());
  if (now_.running && interpolates()) idle = std::min(idle, std::max(0.0, next_publishing() - now));
  return idle;
}

/// Short steps are not waited for one by one: that would take more time than they do.
template <class Real>
double SimulationLoop<Real>::seconds_to_next_steps() const {
  constexpr double shortest_wait = 2e-3;
  const double wait = pace_.wait(now_.speed, live_.simulation().settings().step);
  return wait > 0.0 ? std::max(wait, shortest_wait) : 0.0;
}

template <class Real>
void SimulationLoop<Real>::obey(const Command& command) {
  // Only changes are gathered: of many that come together, as from a slider, the last one is made.
  if (change_wanted_ && !std::holds_alternative<Change>(command)) change(std::exchange(wanted_, {}));
  std::visit([this](const auto& one) { obey(one); }, command);
  changed_ = true;
}

template <class Real>
void SimulationLoop<Real>::obey(const SetRunning& command) {
  if (command.running == now_.running) return;
  now_.running = command.running;
  now_.problem.clear();
  const double now = wall_time();
  pace_.start(now);
  rates_.start(now, live_.simulation().time());
}

template <class Real>
void SimulationLoop<Real>::obey(const StepOnce&) {
  now_.running = false;
  now_.problem.clear();
  take_steps(1);
}

template <class Real>
void SimulationLoop<Real>::obey(const Reset&) {
  const bool was_torn = live_.torn() != nullptr;
  live_.reset();
  if (was_torn) describe();
  now_.problem.clear();
  measured_ = false;
  const double now = wall_time();
  pace_.start(now);
  rates_.start(now, live_.simulation().time());
}

template <class Real>
void SimulationLoop<Real>::obey(const SetSpeed& command) {
  now_.speed = command.speed;
}

template <class Real>
void SimulationLoop<Real>::obey(const Change& command) {
  wanted_ = command.setup;
  change_wanted_ = true;
}

template <class Real>
void SimulationLoop<Real>::change(const Setup& setup) {
  change_wanted_ = false;
  now_.refusal.clear();
  try {
    live_.change(setup);
    describe();
    rates_.forget();
    now_.problem.clear();
  } catch (const std::exception& error) {
    now_.refusal = error.what();
  }
  last_batch_ = 1;
  measured_ = false;
  const double now = wall_time();
  pace_.start(now);  // compiling is no time to make up for
  rates_.start(now, live_.simulation().time());
}

template <class Real>
void SimulationLoop<Real>::describe() {
  const Simulation<Real>& simulation = live_.simulation();
  auto in_force = std::make_shared<InForce>();
  in_force->number = now_.in_force ? now_.in_force->number + 1 : 1;
  in_force->setup = {simulation.settings(), live_.scene().effects};
  in_force->plan = simulation.plan();
  in_force->sweeps = sweeps_of(simulation.plan());
  in_force->stability = step_limit(live_.scene(), simulation.settings().method);
  in_force->particles = simulation.particle_count();
  in_force->springs = simulation.spring_count();
  in_force->torn = live_.torn();
  in_force->threads = simulation.threads();
  now_.in_force = std::move(in_force);
}

template <class Real>
void SimulationLoop<Real>::stop(const std::string& problem) {
  now_.running = false;
  now_.problem = problem;
}

/// So many steps that they take about 5 ms; only twice as many as were taken at once before, as a first, slow
/// step says little.
template <class Real>
std::uint64_t SimulationLoop<Real>::batch(std::uint64_t due) const {
  constexpr double seconds = 5e-3;
  const double affordable = std::min(seconds / std::max(seconds_per_step_, 1e-9), 1e9);
  return std::clamp<std::uint64_t>(std::min(std::uint64_t(affordable), 2 * last_batch_), 1, due);
}

template <class Real>
void SimulationLoop<Real>::take_due_steps(double now) {
  const double step = live_.simulation().settings().step;
  const std::uint64_t due = pace_.steps_due(now, now_.speed, step);
  if (due == 0) return;
  const std::uint64_t count = batch(due);
  take_steps(count);
  pace_.took(count, step);
}

template <class Real>
void SimulationLoop<Real>::take_steps(std::uint64_t count) {
  const double start = wall_time();
  Work work;
  const std::shared_ptr<const Scene> torn = live_.torn();
  const Report report = live_.take_steps(count, work);
  if (live_.torn() != torn) describe();
  const double seconds = wall_time() - start;
  rates_.add_steps(work, seconds);
  seconds_per_step_ = seconds / static_cast<double>(count);
  last_batch_ = count;
  changed_ = true;
  measured_ = false;
  if (!report.ok()) stop(report.message());
}

/// Whether steps are so far apart on the wall clock that a state must be shown between two of them.
template <class Real>
bool SimulationLoop<Real>::interpolates() const {
  return live_.simulation().settings().step > 0.5 * rhythm_.publish_every * now_.speed;
}

/// Wall time [s]. A simulation that is paused loses nothing by showing what was done to it at once.
template <class Real>
double SimulationLoop<Real>::next_publishing() const {
  return now_.running ? publish_at_ : 0.0;
}

template <class Real>
void SimulationLoop<Real>::publish_if_due() {
  const bool moves = now_.running && interpolates();
  if (!changed_ && measured_ && !moves) return;
  const double now = wall_time();
  if (now < next_publishing()) return;
  publish(now);
}

template <class Real>
void SimulationLoop<Real>::publish(double now) {
  constexpr double most_share = 0.03;  // of the thread's time
  const double begun = thread_time();
  if (!measured_ && (now >= measure_at_ || !now_.running)) measure(now);
  const Simulation<Real>& simulation = live_.simulation();
  const double step = simulation.settings().step;
  now_.time = simulation.time();
  now_.steps = simulation.steps();
  now_.speeds = rates_.speeds(now, now_.time, simulation.spring_count());
  Moment& moment = moments_.back();
  std::vector<float> positions = std::move(moment.positions);  // for its memory
  positions.resize(3 * simulation.particle_count());
  simulation.copy_positions(positions.data(), 3 * sizeof(float),
                            now_.running && interpolates() ? pace_.share(step) : 1.0);
  moment = now_;
  moment.positions = std::move(positions);
  moments_.publish();
  changed_ = false;
  rates_.add_publishing(thread_time() - begun);
  publish_cost_ = usual_cost(publish_cost_, wall_time() - now);
  const double seldom = std::max(0.25, rhythm_.publish_every);
  publish_at_ = now + std::clamp(publish_cost_ / most_share, rhythm_.publish_every, seldom);
}

template <class Real>
void SimulationLoop<Real>::measure(double now) {
  constexpr double most_share = 0.01;  // of the thread's time
  const Simulation<Real>& simulation = live_.simulation();
  constexpr std::size_t most_kept = 32;  // for windows that draw less often than this measures
  std::vector<Measurement>& kept = now_.measurements;
  if (kept.size() == most_kept) kept.erase(kept.begin());
  kept.push_back({++measured_count_, simulation.time(), simulation.energy(), simulation.max_strain()});
  measured_ = true;
  measure_cost_ = usual_cost(measure_cost_, wall_time() - now);
  measure_at_ = now + std::max(rhythm_.measure_every, measure_cost_ / most_share);
}

template class SimulationLoop<float>;
template class SimulationLoop<double>;

}  // namespace hooke::viewer
