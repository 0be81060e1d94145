#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// Damped springs and drag, so that a method that loses track of velocities shows.
Scene damped_cloth() {
  Scene scene = hung_cloth(30, 20, 0.01);
  scene.pin(15, {{0.0, {0, 0, 0}}, {0.02, {0, 0, 0.05}}});
  return scene;
}

Settings settings(const Method& method, Accumulation accumulation = Accumulation::gather) {
  return {.method = method, .step = 1e-4, .accumulation = accumulation, .threads = 2};
}

/// A ball that falls and hits the ground, whose force jumps there.
Scene bouncing_ball() {
  Scene scene;
  scene.add_particle(1.0, {0, 1, 0});
  scene.effects = {Gravity{}, GroundPlane{.stiffness = 1e4, .damping = 5.0}};
  return scene;
}

}  // namespace

TEST_CASE("to look at a run between its steps does not change it") {
  const Scene scene = damped_cloth();
  for (const Method& method : all_methods) {
    for (auto accumulation : {Accumulation::gather, Accumulation::coloured}) {
      CAPTURE(to_string(method));
      if (!can_accumulate(method, accumulation)) continue;
      Simulation<float> alone(scene, settings(method, accumulation)),
          watched = Simulation<float>(scene, settings(method, accumulation));
      REQUIRE(alone.step(40).ok());
      for (int i = 0; i < 40; ++i) {
        REQUIRE(watched.step().ok());
        if (i % 3 == 0) CHECK(std::isfinite(watched.energy().total()));
        if (i % 7 == 0) CHECK(watched.snapshot().step == std::uint64_t(i) + 1);
      }
      CHECK(watched.state_hash() == alone.state_hash());
    }
  }
}

TEST_CASE("a run goes on from a snapshot with the same bits, whatever the method carries") {
  const Scene scene = damped_cloth();
  for (const Method& method : all_methods) {
    CAPTURE(to_string(method));
    Simulation<float> whole(scene, settings(method)), first(scene, settings(method));
    REQUIRE(whole.step(60).ok());
    REQUIRE(first.step(30).ok());
    const Snapshot<float> snapshot = first.snapshot();
    Simulation<float> second(scene, settings(method));
    second.restore(snapshot);
    CHECK(second.state_hash() == first.state_hash());
    REQUIRE(second.step(30).ok());
    CHECK(second.state_hash() == whole.state_hash());
  }
}

TEST_CASE("a snapshot of one method goes on with another one, from its positions and velocities") {
  const Scene scene = damped_cloth();
  Simulation<double> verlet(scene, settings(Verlet{}));
  REQUIRE(verlet.step(30).ok());
  const Snapshot<double> snapshot = verlet.snapshot();
  CHECK(!snapshot.method.velocities.empty());
  CHECK(snapshot.method.velocities != snapshot.velocities);
  for (const Method& method : {Method(BlanesMoan{}), Method(RungeKutta4{})}) {
    Simulation<double> other(scene, settings(method));
    other.restore(snapshot);
    CHECK(other.state_hash() == verlet.state_hash());
    REQUIRE(other.step(10).ok());
  }
}

TEST_CASE("velocities and positions that are changed in a snapshot count, whatever the method carries") {
  const Scene scene = damped_cloth();
  for (const Method& method : all_methods) {
    CAPTURE(to_string(method));
    Simulation<double> simulation(scene, settings(method));
    REQUIRE(simulation.step(20).ok());
    Snapshot<double> snapshot = simulation.snapshot();
    snapshot.velocities[3 * 100] += 1.0;
    simulation.restore(snapshot);
    CHECK(velocity(simulation, 100).x() == snapshot.velocities[3 * 100]);
    REQUIRE(simulation.step(5).ok());

    Simulation<double> afresh(scene, settings(method));
    snapshot.method = {};
    afresh.restore(snapshot);
    REQUIRE(afresh.step(5).ok());
    CHECK(afresh.state_hash() == simulation.state_hash());
  }
}

TEST_CASE("a snapshot whose method carries nonsense is refused, and nothing is changed") {
  const Scene scene = damped_cloth();
  Simulation<float> simulation(scene, settings(Verlet{}));
  REQUIRE(simulation.step(3).ok());
  const std::uint64_t before = simulation.state_hash();
  Snapshot<float> snapshot = simulation.snapshot();
  snapshot.method.velocities.pop_back();
  CHECK_THROWS_AS(simulation.restore(snapshot), std::invalid_argument);
  snapshot = simulation.snapshot();
  snapshot.method.pending_kick = std::nan("");
  CHECK_THROWS_AS(simulation.restore(snapshot), std::invalid_argument);
  snapshot = simulation.snapshot();
  snapshot.method.next_step = -1.0;
  CHECK_THROWS_AS(simulation.restore(snapshot), std::invalid_argument);
  CHECK(simulation.state_hash() == before);
}

TEST_CASE("velocities that are made whole on demand may be asked for by several threads at once") {
  const Scene scene = damped_cloth();
  Simulation<float> simulation(scene, settings(Verlet{}));
  REQUIRE(simulation.step(3).ok());
  double first = 0.0, second = 0.0;
  std::thread other([&] { first = simulation.energy().kinetic; });
  second = simulation.energy().kinetic;
  other.join();
  CHECK(first == second);
}

TEST_CASE("the report counts evaluations of forces") {
  const Scene scene = damped_cloth();
  for (const Method& method : all_methods) {
    if (std::holds_alternative<DormandPrince>(method) || solves_equations(method)) continue;
    const int each = std::visit([](const auto& data) { return data.force_evaluations; }, method);
    CHECK(Simulation<float>(scene, settings(method)).step(7).force_evaluations == std::uint64_t(7 * each));
  }
}

TEST_CASE("methods of several stages hold what they need, and the plan says so") {
  const Scene scene = hung_cloth(100, 100);
  const std::size_t one_stage = Simulation<float>(scene, settings(SymplecticEuler{})).plan().bytes();
  const Plan plan = Simulation<float>(scene, settings(RungeKutta4{})).plan();
  // Two states between stages and the accelerations of three stages: 21 numbers for each particle.
  CHECK(double(plan.bytes() - one_stage) == doctest::Approx(21.0 * 4.0 * 100 * 100).epsilon(0.1));
  CHECK(plan.tiles.find("stages in a pass") != std::string::npos);
}

TEST_CASE("error control: a smaller tolerance takes more evaluations, and steps end where they should") {
  const Scene scene = damped_cloth();
  std::uint64_t before = 0;
  for (double tolerance : {1e-3, 1e-5, 1e-7}) {
    Simulation<double> simulation(scene, {.method = DormandPrince{.tolerance = tolerance}, .step = 0.01});
    const Report report = simulation.step(20);
    REQUIRE(report.ok());
    CHECK(report.force_evaluations > before);
    CHECK(simulation.time() == 20 * 0.01);
    before = report.force_evaluations;
  }
}

TEST_CASE("error control takes steps again that were too long, as where the ground is hit") {
  Simulation<double> simulation(bouncing_ball(), {.method = DormandPrince{}, .step = 0.1});
  const Report report = simulation.step(10);
  REQUIRE(report.ok());
  CHECK(report.rejected_steps > 2);
}

TEST_CASE("where the tolerance needs shorter steps than the smallest, the state before is kept") {
  Simulation<double> simulation(
      bouncing_ball(), {.method = DormandPrince{.tolerance = 1e-9, .smallest_step = 1e-3}, .step = 0.1});
  const Report report = simulation.step(10);
  REQUIRE_FALSE(report.ok());
  CHECK((report.flags & flag_step_too_small) != 0);
  CHECK(report.message().find("smallest_step") != std::string::npos);
  CHECK(report.step == report.steps_taken + 1);
  CHECK(simulation.time() == doctest::Approx(0.1 * double(report.steps_taken)));
  CHECK(position(simulation, 0).y() > 0.0);
}

TEST_CASE("positions between two steps of error control lie between those of the steps") {
  Scene scene;
  scene.add_particle(1.0, {0, 0, 0}, {1, 0, 0});
  Simulation<double> simulation(scene, {.method = DormandPrince{}, .step = 0.5});
  REQUIRE(simulation.step(3).ok());
  double middle[3];
  simulation.copy_positions(middle, sizeof middle, 0.5);
  CHECK(middle[0] == doctest::Approx(1.25));
}

TEST_CASE("parameters of error control that cannot be used are refused by name") {
  const auto faults = [](const DormandPrince& method) {
    return validate(one_particle(), {.method = method});
  };
  CHECK(faults({}).empty());
  CHECK(faults({.tolerance = 0.0}).size() == 1);
  CHECK(faults({.position_tolerance = -1.0}).size() == 1);
  CHECK(faults({.velocity_tolerance = std::nan("")}).size() == 1);
  CHECK(faults({.smallest_step = 0.0}).front().element.find("dormand_prince") != std::string::npos);
}
