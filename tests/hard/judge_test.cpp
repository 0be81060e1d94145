// The judge of the hard cases must not pass what did not pass: broken runs, and figures that are none.

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/contact_watch.h"
#include "scenes/hard/measures.h"
#include "scenes/hard/shapes.h"

using namespace hooke;
using namespace hooke::hard;

namespace {

/// A mass of 1 kg on an undamped spring of 1000 N/m, pulled by half of its length.
Scene oscillator() {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  scene.add_particle(1.0, {1.5, 0.0, 0.0});
  scene.add_spring(0, 1, 1e3, 1.0);
  scene.pin(0);
  return scene;
}

Result judged_after(const Scene& scene, const Settings& settings, std::uint64_t steps) {
  return judged(scene, settings, 5, [&](WatchedRun<double>& run, Judge& judge) {
    run.take(steps);
    judge.at_most("nothing of its own", 0.0, 0.0);
  });
}

}  // namespace

TEST_CASE("nothing passes without a figure, and no limit is met by what is not a number") {
  CHECK(Judge().result().outcome == Outcome::fail);
  Judge most, least;
  most.at_most("a figure", std::numeric_limits<double>::quiet_NaN(), 1.0);
  least.at_least("a figure", std::numeric_limits<double>::quiet_NaN(), 1.0);
  CHECK(most.result().outcome == Outcome::fail);
  CHECK(least.result().outcome == Outcome::fail);
}

TEST_CASE(
    "what passed shows its first figure, what failed the first that missed its limit, and all of them as "
    "reasons") {
  Judge judge;
  judge.at_most("length", 1.0, 2.0);
  judge.at_least("share", 0.5, 0.5);
  judge.flag("by the way");
  CHECK(judge.result().outcome == Outcome::pass);
  CHECK(judge.result().figure == 1.0);
  CHECK(judge.result().limit == 2.0);
  CHECK(judge.result().reason == "by the way");

  judge.at_most("error", 3.0, 2.5);
  judge.at_least("height", 0.25, 0.75);
  const Result failed = judge.result();
  CHECK(failed.outcome == Outcome::fail);
  CHECK(failed.figure == 3.0);
  CHECK(failed.limit == 2.5);
  CHECK(failed.figure_of == "error, at most");
  CHECK(failed.reason == "error, at most 2.5: is 3; height, at least 0.75: is 0.25; by the way");

  Judge wrong;
  wrong.at_most("length", 1.0, 2.0);
  wrong.wrong("a step was not taken");
  CHECK(wrong.result().outcome == Outcome::fail);
}

TEST_CASE(
    "explicit Euler that takes its steps on an undamped spring fails by its energy, and is refused where "
    "asked") {
  const Scene scene = oscillator();
  const Result taken =
      judged_after(scene, {.method = ExplicitEuler{}, .step = 1e-3, .unstable_step = UnstableStep::take}, 60);
  CHECK(taken.outcome == Outcome::fail);
  CHECK(taken.figure_of.find("energy") != std::string::npos);
  CHECK(taken.figure > 0.01);

  const Result asked = judged_after(scene, asked_of(ExplicitEuler{}, scene, 1e-3), 60);
  CHECK(asked.outcome == Outcome::refused);
  CHECK(asked.reason.find("explicit_euler") != std::string::npos);
}

TEST_CASE("a run that explodes fails with the report's own words") {
  const Scene scene = hung_sheet(8).scene;
  const Result result =
      judged_after(scene, {.method = Verlet{}, .step = 0.1, .unstable_step = UnstableStep::take}, 10'000);
  CHECK(result.outcome == Outcome::fail);
  CHECK(result.reason.find("not finite") != std::string::npos);
  CHECK(judged_after(scene, {.method = Verlet{}, .step = 0.1}, 10).outcome == Outcome::pass);
}

TEST_CASE("work done from outside is no excess of energy, and energy from nowhere is") {
  const Scene scene = oscillator();
  WatchedRun<double> run(scene, {.method = Verlet{}, .step = 1e-4});
  run.take(10);
  Snapshot<double> snapshot = run.snapshot();
  snapshot.positions[3] = 5.0;
  run.place(snapshot);
  run.take(1000);
  CHECK(run.energy_excess() < 1e-4);

  WatchedRun<double> growing(scene,
                             {.method = ExplicitEuler{}, .step = 1e-3, .unstable_step = UnstableStep::take});
  growing.take(1000);
  CHECK(growing.energy_excess() > 0.5);
  CHECK(growing.largest_rise() > 0.0);
}

TEST_CASE(
    "what attached frames put in by their paths is work, drawn and turned; without them it is an excess") {
  Scene drawn = sheet(6).scene;
  drawn.springs.damping.assign(drawn.springs.size(), 0.01);
  FrameAttachment edge{.particles = {0, 6, 12, 18, 24, 30}, .axis = Vec3::UnitX()};
  edge.path = {{0.0, Vec3::Zero(), 0.0}, {1.0, Vec3(-1.0, 0.2, 0.0), 180.0}};
  drawn.effects = {edge};
  drawn.pin(5);
  drawn.pin(35);
  WatchedRun<double> run(drawn, {.method = SymplecticEuler{}, .step = 1e-3});
  const double before = run.simulation().energy().total();
  run.take(500);
  CHECK(run.simulation().energy().total() > before + 1.0);
  CHECK(run.energy_excess() < 0.01);

  Scene scripted = drawn;
  scripted.effects = {MotionScript{edge.particles, {{0.0, Vec3::Zero()}, {1.0, Vec3(-1.0, 0.2, 0.0)}}}};
  WatchedRun<double> unknown(scripted, {.method = SymplecticEuler{}, .step = 1e-3});
  unknown.take(500);
  CHECK(unknown.energy_excess() > 0.5);
}

TEST_CASE("edges through triangles and strained springs end what is watched, and are judged") {
  Scene scene;
  for (const Vec3& x : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}) scene.pin(scene.add_particle(1.0, x));
  for (const Vec3& x : {Vec3(0.2, 0.2, 1), Vec3(0.3, 0.2, 1.5), Vec3(0.2, 0.3, 1.5)})
    scene.add_particle(1.0, x, {0.0, 0.0, -2.0});
  scene.triangles = {{0, 1, 2}, {3, 4, 5}};
  scene.add_spring(0, 1, 1.0, 0.8);
  WatchedRun<double> run(scene, {.method = Verlet{}, .step = 0.1});
  ContactWatch watch(scene, 0.5);
  run.take(4);
  CHECK(watch.look(run));
  run.take(2);
  CHECK(!watch.look(run));
  Judge judge;
  watch.judge(judge);
  CHECK(judge.result().outcome == Outcome::fail);
  CHECK(judge.result().figure_of == "edges through triangles, at most");
  CHECK(watch.strain() == doctest::Approx(0.25));
  CHECK(!ContactWatch(scene, 0.2).look(run));
}

TEST_CASE("measures of states: strains, forces and distances in closed form") {
  Scene scene = oscillator();
  scene.effects = {Gravity{{0.0, -10.0, 0.0}}};
  const std::vector<Vec3>& positions = scene.particles.position;
  CHECK(strains(scene, positions).at(0) == doctest::Approx(0.5));
  CHECK(share_within(scene, positions, 0.4) == 0.0);
  CHECK(share_within(scene, positions, 0.6) == 1.0);
  CHECK(largest_force(scene, positions) == doctest::Approx(std::hypot(500.0, 10.0)));
  CHECK(weight(scene) == doctest::Approx(10.0));
  CHECK(largest_distance({Vec3::Zero(), Vec3::UnitX()}, {Vec3::Zero(), 3.0 * Vec3::UnitX()}) == 2.0);
}
