// Steps of a scene that may tear, and how a run goes on in a scene that has.

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "model/precision.h"
#include "report_of_steps.h"
#include "simulation_parts.h"
#include "stability/step_division.h"
#include "tearing/carried_memory.h"

namespace hooke {
namespace {

constexpr std::string_view sweep_name = "tearing";

/// Vectors of particles, with those of new ones behind them.
template <class Real>
void append_split(const std::vector<Index>& split_from, std::vector<Real>& vectors) {
  if (vectors.empty()) return;
  for (const Index from : split_from) {
    for (std::size_t k = 0; k < 3; ++k) vectors.push_back(Real(vectors[3 * from + k]));
  }
}

/// Those that relaxed before, by their new numbers, and those beside what has torn now.
std::vector<RelaxingSpring> all_relaxing(const std::vector<RelaxingSpring>& before, const TornScene& torn) {
  std::vector<RelaxingSpring> all = torn.relaxing;
  for (const RelaxingSpring& one : before) {
    const Index number = torn.number_after[one.spring];
    const bool is_new = !std::ranges::binary_search(torn.relaxing, number, {}, &RelaxingSpring::spring);
    if (number != TornScene::none && is_new) all.push_back({number, one.length});
  }
  std::ranges::sort(all, {}, &RelaxingSpring::spring);
  return all;
}

void require(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument("snapshot: " + message);
}

std::size_t bytes_of(const Scene& scene) {
  const auto& [first, second, stiffness, rest_length, damping] = scene.springs;
  const std::size_t indices = first.capacity() + second.capacity() + 3 * scene.triangles.capacity();
  const std::size_t numbers = stiffness.capacity() + rest_length.capacity() + damping.capacity() +
                              scene.particles.mass.capacity() + 3 * scene.particles.position.capacity() +
                              3 * scene.particles.velocity.capacity();
  return indices * sizeof(Index) + numbers * sizeof(double);
}

}  // namespace

template <class Real>
void Simulation<Real>::Parts::begin_tearing(Tears<Real> made) {
  tears.emplace(std::move(made));
  const std::size_t bytes =
      tears->springs.bytes() + bytes_of(*tears->start) + (tears->torn() ? bytes_of(*tears->now) : 0);
  show_between_steps({std::string(Tearing::name),
                      std::string(sweep_name),
                      {"position"},
                      {"particles", "springs", "triangles"},
                      bytes},
                     sweep_name);
}

template <class Real>
Report Simulation<Real>::Parts::take_tearing_steps(std::unique_ptr<Parts>& parts, std::uint64_t count) {
  using WallClock = std::chrono::steady_clock;
  parts->begin_report();
  Report report;
  while (report.steps_taken < count && report.ok()) {
    Report step;
    parts->take_steps(1, step);
    add_step(step, report);
    if (!step.ok()) break;
    const WallClock::time_point start = WallClock::now();
    tear(parts, report);
    parts->time_of(sweep_name).seconds += std::chrono::duration<double>(WallClock::now() - start).count();
  }
  parts->end_report(report);
  return report;
}

template <class Real>
void Simulation<Real>::Parts::tear(std::unique_ptr<Parts>& parts, Report& report) {
  Parts& before = *parts;
  const std::vector<Index> springs = before.tears->springs.find(before.states.now(), *before.executor);
  if (springs.empty()) return;
  TornScene torn = hooke::tear(*before.tears->now, before.positions(), springs);
  if (!torn.torn()) {
    before.tears->springs.relax(all_relaxing(before.tears->springs.relaxing(), torn));
    return;
  }
  const std::vector<Index> split_from = torn.split_from;
  const Snapshot<Real> snapshot = before.torn_snapshot(std::move(torn));
  StepBounds bounds{bounds_of(*snapshot.torn), 0.0};
  const Settings settings = before.settings_of_scene(true);
  bounds.longest_step = largest_stable_step(bounds.scene, settings.method);
  std::vector<Fault> faults;
  check_stability(faults, bounds, settings);
  if (!faults.empty()) throw SceneError(std::move(faults));
  std::unique_ptr<Parts> after = before.torn_to(snapshot.torn, snapshot, bounds);
  after->restore(snapshot);
  after->take_over(before, split_from);
  before.forces.effects().tell(report);
  report.particles_split += split_from.size();
  parts = std::move(after);
}

template <class Real>
std::vector<Vec3> Simulation<Real>::Parts::positions() const {
  std::vector<Vec3> found(model.particles());
  for (std::size_t i = 0; i < found.size(); ++i)
    found[i] = states.now().position(model.order.engine(i)).template cast<double>();
  return found;
}

/// The newest state in the torn scene. A kick that is pending is done first: its forces are those from
/// before the tear.
template <class Real>
Snapshot<Real> Simulation<Real>::Parts::torn_snapshot(TornScene torn) {
  Snapshot<Real> state = snapshot();
  state.effects = carried_memory(state.effects, forces.effects(), *tears->now, torn);
  for (auto* vectors :
       {&state.positions, &state.velocities, &state.method.positions_before, &state.method.velocities_before})
    append_split(torn.split_from, *vectors);
  state.resting.clear();  // islands are others
  state.method.velocities.clear();
  state.method.pending_kick = 0.0;
  state.method.state = hash_of_state(state);
  const std::size_t at_start = tears->start->particles.size();
  state.torn_from = tears->torn_from;
  for (const Index from : torn.split_from)
    state.torn_from.push_back(from < at_start ? from : state.torn_from[from - at_start]);
  state.relaxing = all_relaxing(tears->springs.relaxing(), torn);
  state.torn = std::make_shared<const Scene>(std::move(torn.scene));
  return state;
}

/// A split makes lighter particles, which may need shorter steps: a run that goes well is not to end for it.
template <class Real>
Settings Simulation<Real>::Parts::settings_of_scene(bool torn) const {
  Settings own = settings;
  own.unstable_step =
      torn && tears->unstable_step == UnstableStep::refuse ? UnstableStep::divide : tears->unstable_step;
  return own;
}

template <class Real>
auto Simulation<Real>::Parts::torn_to(std::shared_ptr<const Scene> scene, const Snapshot<Real>& snapshot,
                                      const StepBounds& bounds) const -> std::unique_ptr<Parts> {
  const bool torn = scene != tears->start;
  auto made = std::make_unique<Parts>(*scene, settings_of_scene(torn), bounds, executor, model.meshes);
  StrainedSprings<Real> springs(*scene, made->model.order, snapshot.relaxing);
  made->begin_tearing(
      {tears->start, std::move(scene), snapshot.torn_from, tears->unstable_step, std::move(springs)});
  return made;
}

/// What a snapshot has not: times of the sweeps so far, and the state before the newest, which positions
/// between steps are drawn from.
template <class Real>
void Simulation<Real>::Parts::take_over(const Parts& before, const std::vector<Index>& split_from) {
  time_at_step_0 = before.time_at_step_0;
  for (SweepTime& time : times) {
    const auto same = std::ranges::find(before.times, time.sweep, &SweepTime::sweep);
    if (same != before.times.end()) time.seconds = same->seconds;
  }
  if (solved && solved->uses_before()) return;  // it has been restored
  State<Real>& own = states.make_before();
  const std::size_t particles_before = before.model.particles();
  for (std::size_t i = 0; i < model.particles(); ++i) {
    const Index from = i < particles_before ? Index(i) : split_from[i - particles_before];
    own.set_position(model.order.engine(i), before.states.before().position(before.model.order.engine(from)));
  }
}

template <class Real>
auto Simulation<Real>::Parts::for_scene_of(const Snapshot<Real>& snapshot) const -> std::unique_ptr<Parts> {
  require(tears || (!snapshot.torn && snapshot.torn_from.empty()),
          "it is of a scene that has torn, and this one names no tearing");
  if (!tears) return nullptr;
  const std::shared_ptr<const Scene>& scene = snapshot.torn ? snapshot.torn : tears->start;
  const std::size_t at_start = tears->start->particles.size();
  require(scene->particles.size() == at_start + snapshot.torn_from.size(),
          "torn_from has " + std::to_string(snapshot.torn_from.size()) +
              " particles, but the torn scene has " + std::to_string(scene->particles.size()) +
              ", and that at the start " + std::to_string(at_start));
  for (const Index from : snapshot.torn_from)
    require(from < at_start, "torn_from names particle " + std::to_string(from) + ", and the scene has " +
                                 std::to_string(at_start));
  require(scene->effects.size() == tears->start->effects.size(), "the torn scene has other effects");
  for (const RelaxingSpring& one : snapshot.relaxing)
    require(one.spring < scene->springs.size(), "relaxing names spring " + std::to_string(one.spring) +
                                                    ", and the scene has " +
                                                    std::to_string(scene->springs.size()));
  if (scene == tears->now) return nullptr;
  CheckedScene checked = check(*scene, settings_of_scene(scene != tears->start));
  if (checked.faults.empty()) checked.faults = validate_precision<Real>(*scene);
  if (!checked.faults.empty()) throw SceneError(std::move(checked.faults));
  return torn_to(scene, snapshot, checked.bounds);
}

template struct Simulation<float>::Parts;
template struct Simulation<double>::Parts;

}  // namespace hooke
