#include "viewer/live/simulation_thread.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "scenes.h"
#include "viewer/live_run.h"

namespace hooke::viewer {
namespace {

using test::wait_until;

/// Steps of half of what is stable for every method that is stable at all.
constexpr double step = 5e-4;

Settings settings_of(const Method& method = SymplecticEuler{}) {
  Settings settings;
  settings.method = method;
  settings.step = step;
  settings.threads = 2;
  return settings;
}

/// The positions of a run of so many steps that nobody looks at.
std::vector<float> positions_after(const Scene& scene, const Settings& settings, std::uint64_t steps) {
  Simulation<float> simulation(scene, settings);
  simulation.step(steps);
  std::vector<float> positions(3 * simulation.particle_count());
  simulation.copy_positions(positions.data(), 3 * sizeof(float));
  return positions;
}

bool has_stopped(const Moment& moment) {
  return !moment.running;
}

}  // namespace

TEST_CASE("the simulation's thread starts paused, at the scene's start") {
  const Scene scene = test::hung_cloth(8, 8);
  SimulationThread thread(scene, settings_of());
  CHECK_FALSE(thread.moment().running);
  CHECK(thread.moment().time == 0.0);
  CHECK(thread.moment().in_force->particles == 64);
  CHECK(thread.moment().positions == positions_after(scene, settings_of(), 0));
}

TEST_CASE("single steps of a paused simulation are those of a simulation alone") {
  const Scene scene = test::hung_cloth(8, 8);
  SimulationThread thread(scene, settings_of());
  for (int i = 0; i < 3; ++i) thread.send(StepOnce{});
  REQUIRE(wait_until(thread, [](const Moment& moment) { return moment.steps == 3; }));
  CHECK(thread.moment().positions == positions_after(scene, settings_of(), 3));
  CHECK(thread.moment().time == doctest::Approx(3 * step));
}

TEST_CASE("a run that is paused has the same bits as one alone, and stands still") {
  const Scene scene = test::hung_cloth(8, 8);
  SimulationThread thread(scene, settings_of());
  thread.send(SetRunning{true});
  REQUIRE(wait_until(thread, [](const Moment& moment) { return moment.time > 0.05; }));
  thread.send(SetRunning{false});
  REQUIRE(wait_until(thread, has_stopped));
  const std::uint64_t steps = thread.moment().steps;
  CHECK(thread.moment().positions == positions_after(scene, settings_of(), steps));
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  thread.fetch();
  CHECK(thread.moment().steps == steps);
}

TEST_CASE("reset goes back to the start, and the run goes on") {
  const Scene scene = test::hung_cloth(8, 8);
  SimulationThread thread(scene, settings_of());
  for (int i = 0; i < 5; ++i) thread.send(StepOnce{});
  thread.send(Reset{});
  thread.send(StepOnce{});
  REQUIRE(wait_until(thread, [](const Moment& moment) { return moment.steps == 1; }));
  CHECK(thread.moment().positions == positions_after(scene, settings_of(), 1));
}

TEST_CASE("another method, step, threads or accumulation keep state and time") {
  const Scene scene = test::hung_cloth(8, 8);
  SimulationThread thread(scene, settings_of());
  for (int i = 0; i < 100; ++i) thread.send(StepOnce{});
  REQUIRE(wait_until(thread, [](const Moment& moment) { return moment.steps == 100; }));
  const std::vector<float> positions = thread.moment().positions;
  std::uint64_t number = thread.moment().in_force->number;
  for (const Method& method : all_methods) {
    for (const Accumulation accumulation : accumulations) {
      CAPTURE(to_string(method));
      CAPTURE(to_string(accumulation));
      if (!can_accumulate(method, accumulation)) continue;
      Setup setup{settings_of(method), scene.effects};
      setup.settings.accumulation = accumulation;
      setup.settings.step = 0.5 * step;
      setup.settings.threads = 1;
      thread.send(Change{setup});
      ++number;
      REQUIRE(wait_until(thread, [&](const Moment& moment) { return moment.in_force->number == number; }));
      const Moment& moment = thread.moment();
      CHECK(moment.refusal.empty());
      CHECK(to_string(moment.in_force->setup.settings.method) == to_string(method));
      CHECK(moment.in_force->setup.settings.accumulation == accumulation);
      CHECK(moment.in_force->threads == 1);
      CHECK(moment.time == doctest::Approx(100 * step));
      CHECK(moment.positions == positions);
    }
  }
  thread.send(StepOnce{});
  REQUIRE(wait_until(thread, [](const Moment& moment) { return moment.steps == 101; }));
  CHECK(thread.moment().time == doctest::Approx(100.5 * step));
}

TEST_CASE("coefficients of effects can be changed, and an effect be left out") {
  SimulationThread thread(test::hung_cloth(4, 4), settings_of());
  thread.send(Change{{settings_of(), {Gravity{.acceleration = Vec3(0, 3, 0)}}}});
  thread.send(StepOnce{});
  REQUIRE(wait_until(thread, [](const Moment& moment) { return moment.steps == 1; }));
  CHECK(thread.moment().in_force->setup.effects.size() == 1);
  // A free particle rises by g h^2; it was at (0.02, 0 or below).
  const std::vector<float> start = positions_after(test::hung_cloth(4, 4), settings_of(), 0);
  CHECK(thread.moment().positions[3 * 5 + 1] - start[3 * 5 + 1] ==
        doctest::Approx(3 * step * step).epsilon(0.05));
}

TEST_CASE("a change that cannot be made is refused with the reason, and the old simulation goes on") {
  SimulationThread thread(test::hung_cloth(4, 4), settings_of());
  Setup setup{settings_of(), {Drag{.coefficient = -1.0}}};
  thread.send(Change{setup});
  REQUIRE(wait_until(thread, [](const Moment& moment) { return !moment.refusal.empty(); }));
  CHECK(thread.moment().refusal.find("drag") != std::string::npos);
  CHECK(thread.moment().in_force->setup.effects.size() == 2);
  setup = {settings_of(), {}};
  setup.settings.step = -1.0;
  thread.send(Change{setup});
  REQUIRE(wait_until(thread,
                     [](const Moment& moment) { return moment.refusal.find("step") != std::string::npos; }));
  thread.send(StepOnce{});
  REQUIRE(wait_until(thread, [](const Moment& moment) { return moment.steps == 1; }));
}

TEST_CASE("of many changes that come together only the last is made") {
  SimulationThread thread(test::hung_cloth(32, 32), settings_of());
  const int changes = 200;
  for (int i = 1; i <= changes; ++i) thread.send(Change{{settings_of(), {Drag{.coefficient = 1e-6 * i}}}});
  const auto last_is_made = [](const Moment& moment) {
    const Effect& effect = moment.in_force->setup.effects.front();
    return std::holds_alternative<Drag>(effect) && std::get<Drag>(effect).coefficient == 1e-6 * changes;
  };
  REQUIRE(wait_until(thread, last_is_made));
  CHECK(thread.moment().in_force->number < changes);
}

TEST_CASE(
    "a run that goes bad stops with the engine's message; its last good state stays, and it can be reset") {
  Settings settings = settings_of();
  settings.step = 0.05;  // far beyond what is stable
  settings.unstable_step = UnstableStep::take;
  SimulationThread thread(test::hung_cloth(8, 8), settings);
  thread.send(SetSpeed{1000.0});
  thread.send(SetRunning{true});
  REQUIRE(wait_until(thread, [](const Moment& moment) { return !moment.problem.empty(); }));
  const Moment& moment = thread.moment();
  CHECK_FALSE(moment.running);
  CHECK(moment.problem.find("use a smaller step") != std::string::npos);
  for (const float x : moment.positions) CHECK(std::isfinite(x));
  thread.send(Reset{});
  REQUIRE(wait_until(thread, [](const Moment& now) { return now.problem.empty() && now.steps == 0; }));
  thread.send(Change{{settings_of(), {Gravity{}}}});
  thread.send(SetRunning{true});
  REQUIRE(wait_until(thread, [](const Moment& now) { return now.time > 0.05 && now.problem.empty(); }));
}

TEST_CASE("a change lets a run that went bad go on from its last good state") {
  Settings settings = settings_of();
  settings.step = 0.05;
  settings.unstable_step = UnstableStep::take;
  SimulationThread thread(test::hung_cloth(8, 8), settings);
  thread.send(SetSpeed{1000.0});
  thread.send(SetRunning{true});
  REQUIRE(wait_until(thread, [](const Moment& moment) { return !moment.problem.empty(); }));
  const double time = thread.moment().time;
  thread.send(Change{{settings_of(), {}}});
  REQUIRE(wait_until(thread, [](const Moment& moment) { return moment.problem.empty(); }));
  CHECK(thread.moment().time == time);
}

TEST_CASE("in real time, simulated time keeps pace with the clock times the speed") {
  SimulationThread thread(test::hung_cloth(4, 4), settings_of());
  thread.send(SetSpeed{0.5});
  thread.send(SetRunning{true});
  REQUIRE(wait_until(thread, [](const Moment& moment) { return moment.speeds.real_time_ratio > 0.0; }));
  const double before = thread.moment().time;
  const auto start = std::chrono::steady_clock::now();
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  thread.fetch();
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  // Never faster; how much slower is up to who else uses the machine.
  CHECK(thread.moment().time - before < 0.5 * wall + 0.1);
  CHECK(thread.moment().time > before);
}

TEST_CASE("a scene that is too costly for its speed falls behind and still obeys at once") {
  SimulationThread thread(test::hung_cloth(64, 64), settings_of());
  thread.send(SetSpeed{256.0});
  thread.send(SetRunning{true});
  REQUIRE(wait_until(thread, [](const Moment& moment) { return moment.speeds.real_time_ratio > 0.0; }));
  CHECK(thread.moment().speeds.real_time_ratio < 256.0);
  CHECK(thread.moment().speeds.springs_per_second > 0.0);
  CHECK(thread.moment().speeds.sweeps.size() == thread.moment().in_force->sweeps.size());
  thread.send(SetRunning{false});
  const auto start = std::chrono::steady_clock::now();
  REQUIRE(wait_until(thread, has_stopped));
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(2));
}

TEST_CASE("between steps that are far apart on the clock, a state in between is shown") {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero(), Vec3(1, 0, 0));
  Settings settings;
  settings.step = 0.05;
  SimulationThread thread(scene, settings);
  thread.send(SetSpeed{0.2});  // a step takes a quarter of a second
  thread.send(SetRunning{true});
  const auto is_between = [&](const Moment& moment) {
    const double steps = double(moment.positions[0]) / settings.step;
    return moment.steps >= 2 && std::abs(steps - std::round(steps)) > 0.1;
  };
  CHECK(wait_until(thread, is_between));
}

TEST_CASE("energy and strain are those of the state that is shown") {
  const Scene scene = test::hung_cloth(8, 8);
  SimulationThread thread(scene, settings_of(), Precision::twofold);
  for (int i = 0; i < 50; ++i) thread.send(StepOnce{});
  REQUIRE(wait_until(thread, [](const Moment& moment) {
    return moment.steps == 50 && !moment.measurements.empty() &&
           moment.measurements.back().time == moment.time;
  }));
  Simulation<double> alone(scene, settings_of());
  for (int i = 0; i < 50; ++i) alone.step();
  const Measurement& measured = thread.moment().measurements.back();
  CHECK(measured.energy.total() == alone.energy().total());
  CHECK(measured.max_strain == alone.max_strain());
}

}  // namespace hooke::viewer
