#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <hooke/simulation.h>

#include "controlled_steps.h"
#include "forces.h"
#include "measure.h"
#include "methods/whole_state.h"
#include "model/model.h"
#include "parallel/tile_workers.h"
#include "plan.h"
#include "sleep/sleepers.h"
#include "solve/solved_steps.h"
#include "stability/energy_watch.h"
#include "stability/stability_report.h"
#include "state_ring.h"
#include "tearing/tears.h"
#include "tearing/torn_scene.h"

namespace hooke {

/// What a simulation owns, in the order in which it is made.
template <class Real>
struct Simulation<Real>::Parts {
  Settings settings;
  StabilityParts stability;
  std::uint64_t substeps;  ///< that each step is taken in
  std::shared_ptr<Executor> executor;
  Model<Real> model;
  Forces<Real> forces;
  Scheme<Real> scheme;
  std::optional<SolvedSteps<Real>> solved;  ///< of a method that solves equations
  CompiledPlan<Real> plan;
  TileWorkers workers;
  StateRing<Real> states;
  std::vector<State<Real>> between;  ///< states between the stages of a step
  WholeState<Real> whole;
  std::optional<ControlledSteps<Real>> controlled;  ///< of a method with error control
  std::optional<EnergyWatch<Real>> watch;           ///< of a run whose energy is watched
  std::optional<Tears<Real>> tears;                 ///< of a scene that may tear
  std::optional<Sleepers<Real>> sleepers;           ///< of a scene of which parts may sleep
  Clock clock;
  std::uint64_t steps = 0;
  double time_at_step_0 = 0.0;  ///< [s] not zero after a snapshot from steps of another length
  std::vector<SweepTime> times;
  std::optional<Report>
      stopped;  ///< of the trouble that stopped the run, until the state is set from outside

  Parts(const Scene& scene, Settings given);

  /// Of a scene without faults, whose bounds are known; on the threads of another simulation, and with the
  /// meshes that it has prepared.
  Parts(const Scene& scene, Settings given, const StepBounds& bounds, std::shared_ptr<Executor> threads,
        std::shared_ptr<PreparedMeshes> meshes);

  /// Takes up to `count` steps; stops before one that goes bad, and reports it.
  Report take_steps(std::uint64_t count);

  /// Likewise where the scene may tear: simulation_tearing.cpp. Each step is looked at, and where something
  /// tears, `parts` become those of the torn scene.
  static Report take_tearing_steps(std::unique_ptr<Parts>& parts, std::uint64_t count);

  /// The scene is one that may tear.
  void begin_tearing(Tears<Real> made);

  /// New ones for the scene of a snapshot, at its start; null where it is the one that these are of. Throws
  /// std::invalid_argument where this scene cannot have torn to that one.
  std::unique_ptr<Parts> for_scene_of(const Snapshot<Real>& snapshot) const;

  /// The scene is one of which parts may sleep.
  void begin_sleep(const Sleep& sleep);

  /// After any of them fell asleep or woke.
  void follow_sleepers();

  /// Wakes the islands of some particles of the user's.
  void wake(std::span<const Index> particles);

  Snapshot<Real> snapshot();
  void restore(const Snapshot<Real>& snapshot);

  /// Energies of the newest state.
  Energy energy();

  /// The energy of the newest state is as it should be: it was set from outside.
  void begin_watch();

  /// From now on steps are taken in so many parts.
  void set_substeps(std::uint64_t count);

  double substep_length() const { return settings.step / double(substeps); }  ///< [s]

  /// The newest state with whole velocities.
  const State<Real>& whole_state() { return whole.of(states.now(), model, forces, *executor); }

 private:
  /// What take_steps() does before steps, in them and after them. The steps that `report` has count.
  void begin_report();
  void take_steps(std::uint64_t count, Report& report);
  void end_report(Report& report);

  /// Likewise of what is awake: simulation_sleep.cpp.
  void take_sleeping_steps(std::uint64_t count, Report& report);
  void take_awake_steps(std::uint64_t count, Report& report);
  void rest_until(double time);

  /// Wakes what a step that is not yet the newest has touched. Whether there was any.
  bool wake_met();

  /// Computes a step by take(), again where it met something asleep, which is awake then.
  template <class Take>
  auto with_all_met_awake(const Take& take) {
    auto taken = take();
    while (wake_met()) taken = take();
    return taken;
  }

  /// Adds what is done between steps to what is shown of the plan, and to what is timed.
  void show_between_steps(Stage stage, std::string_view sweep);

  /// Of a sweep of the plan, or of what is done between steps.
  SweepTime& time_of(std::string_view sweep) { return *std::ranges::find(times, sweep, &SweepTime::sweep); }

  /// Tears what is strained too much in the newest state.
  static void tear(std::unique_ptr<Parts>& parts, Report& report);
  std::vector<Vec3> positions() const;
  Snapshot<Real> torn_snapshot(TornScene torn);
  std::unique_ptr<Parts> torn_to(std::shared_ptr<const Scene> scene, const Snapshot<Real>& snapshot,
                                 const StepBounds& bounds) const;
  Settings settings_of_scene(bool torn) const;
  void take_over(const Parts& before, const std::vector<Index>& split_from);

  PlanRun<Real> run() { return {plan, scheme, workers, *executor, between, times}; }

  /// Of substeps, from the one after the first `taken` of the next step on.
  StepTimes substep_times(std::uint64_t taken) const {
    return {time_at_step_0, steps * substeps + taken, settings.step, double(substeps)};
  }

  /// How many of `left` >= 1 steps to take at once.
  std::uint64_t steps_at_once(std::uint64_t left) const;

  /// Takes as many steps as go well, up to `count`.
  void take_fixed_steps(std::uint64_t count, Report& report);
  void take_controlled_steps(std::uint64_t count, Report& report);
  void take_solved_steps(std::uint64_t count, Report& report);

  /// Takes steps as take_fixed_steps() does, looks after its energy and acts on trouble as the settings say:
  /// simulation_trouble.cpp.
  void take_watched_steps(std::uint64_t count, Report& report);
  void act_on_trouble(const Report& found, std::uint64_t steps_at_start, Report& report);
  Report find_trouble(Report found);
  void name_most_energetic(Report& report);
  double energy_factor() const;
  bool energy_is_good(Report& report);
  void go_back();

  /// Takes `count` steps, with at most plan.most_steps_at_once substeps in all or only one of them, and
  /// returns Report::none; or returns a particle that went bad and stays in the state before.
  Index take_at_once(std::size_t count);

  /// Likewise one step in substeps; the particle is then the first one, by number, that went bad. The state
  /// before the step becomes the one before the newest.
  Index take_divided();

  /// Computes the substeps of a step, at most so many at once, and leaves it to the caller to advance.
  Index take_substeps(std::size_t most_at_once);

  /// Runs a step. Where it throws, as a callback of the user's may, the newest state stays whole.
  template <class Attempt>
  auto attempt(const Attempt& attempt);
};

}  // namespace hooke
