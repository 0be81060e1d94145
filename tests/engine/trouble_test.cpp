// Runs that go wrong: found, named, and dealt with as the user says; and runs that go well, in which nothing
// is found.

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "irregular_mesh.h"
#include "sanitized.h"
#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// A cloth of which one spring is far too stiff for the step, which is taken all the same.
Scene cloth_with_stiff_spring() {
  Scene scene = hung_cloth(20, 20);
  scene.springs.stiffness[300] = 1e7;
  return scene;
}

Settings watched(OnTrouble choice) {
  return {.step = 1e-3, .unstable_step = UnstableStep::take, .on_trouble = choice};
}

template <class Real>
std::vector<Real> positions(const Simulation<Real>& simulation) {
  std::vector<Real> result(3 * simulation.particle_count());
  simulation.copy_positions(result.data(), 3 * sizeof(Real));
  return result;
}

/// The scene in which energy comes from everywhere: a ground, moving pins, damped springs, drag.
Scene busy_scene() {
  Scene scene = hung_cloth(14, 12, 0.002);
  add(scene, irregular_mesh(9));
  scene.pin(30, {{0.0, {0, 0, 0}}, {0.2, {0.5, 0.3, 0}}, {0.4, {-0.5, 0, 0.4}}, {0.5, {0, 0, 0}}});
  scene.pin(100, {{0.05, {0, 0, 0}}, {0.06, {0, 0.3, 0}}});
  scene.effects.push_back(GroundPlane{.height = -0.3, .stiffness = 50.0, .damping = 0.01});
  return scene;
}

}  // namespace

TEST_CASE_TEMPLATE(
    "energy that grows is found, with its step, particle and spring, and the good state restored", Real,
    float, double) {
  const Scene scene = cloth_with_stiff_spring();
  const Index a = scene.springs.first[300], b = scene.springs.second[300];
  for (auto accumulation : {Accumulation::gather, Accumulation::coloured}) {
    Settings settings = watched(OnTrouble::stop);
    settings.accumulation = accumulation;
    Simulation<Real> simulation(scene, settings);
    const Report report = simulation.step(100'000);
    REQUIRE_FALSE(report.ok());
    CHECK((report.flags & flag_restored) != 0);
    CHECK((report.flags & flag_energy_grew) != 0);
    CHECK((report.first_bad_particle == a || report.first_bad_particle == b));
    CHECK(report.strained_spring == std::array{std::min(a, b), std::max(a, b)});
    CHECK(report.kinetic_energy > 10.0 * report.energy_put_in);
    CHECK(report.step > simulation.steps());
    CHECK(report.step <= simulation.steps() + 512);
    CHECK(report.steps_taken == simulation.steps());
    CHECK(report.message().find("the spring between " + std::to_string(std::min(a, b))) != std::string::npos);
    CHECK(report.message().find("is restored") != std::string::npos);

    // It stays where it is, and says so, until something is changed.
    const std::uint64_t hash = simulation.state_hash();
    const Report again = simulation.step(3);
    CHECK(again.flags == report.flags);
    CHECK(again.steps_taken == 0);
    CHECK(again.step == report.step);
    CHECK(simulation.state_hash() == hash);
    simulation.restore(simulation.snapshot());
    CHECK(simulation.step(1).ok());
  }
}

TEST_CASE("the restored state is one that the run was in") {
  Simulation<float> stopped(cloth_with_stiff_spring(), watched(OnTrouble::stop));
  REQUIRE_FALSE(stopped.step(100'000).ok());
  Simulation<float> same(cloth_with_stiff_spring(), watched(OnTrouble::ignore));
  REQUIRE(same.step(stopped.steps()).ok());
  CHECK(same.state_hash() == stopped.state_hash());
}

TEST_CASE("steps taken back before a call are counted") {
  Simulation<float> simulation(cloth_with_stiff_spring(), watched(OnTrouble::stop));
  Report report;
  std::uint64_t before = 0;
  do {
    before = simulation.steps();
    report = simulation.step(1);
  } while (report.ok());
  CHECK(report.steps_taken == 0);
  CHECK(report.steps_undone == before - simulation.steps());
}

TEST_CASE("halved steps go on to where the run was to be, with the bits of shorter steps") {
  const Scene scene = cloth_with_stiff_spring();
  Simulation<double> simulation(scene, watched(OnTrouble::halve));
  std::uint32_t flags = 0;
  for (int i = 0; i < 20; ++i) {
    const Report report = simulation.step(25);
    REQUIRE(report.ok());
    flags |= report.flags;
  }
  CHECK((flags & flag_step_halved) != 0);
  CHECK((flags & flag_restored) == 0);
  CHECK(simulation.steps() == 500);
  CHECK(simulation.time() == doctest::Approx(0.5));
  const double substeps = double(simulation.plan().substeps);
  CHECK(1e-3 / substeps < 1.5 * largest_stable_step(scene, SymplecticEuler{}));
  CHECK(simulation.energy().kinetic < 10.0);
}

TEST_CASE("a snapshot of a run of halved steps goes on with the same bits") {
  for (const Method& method : {Method(SymplecticEuler{}), Method(Verlet{})}) {
    Settings settings = watched(OnTrouble::halve);
    settings.method = method;
    Simulation<float> whole(cloth_with_stiff_spring(), settings),
        restored(cloth_with_stiff_spring(), settings);
    REQUIRE(whole.step(300).ok());
    REQUIRE(whole.plan().substeps > 1);
    restored.restore(whole.snapshot());
    CHECK(restored.plan().substeps == whole.plan().substeps);
    REQUIRE(whole.step(100).ok());
    REQUIRE(restored.step(100).ok());
    CHECK(restored.state_hash() == whole.state_hash());
  }
}

TEST_CASE("what becomes of trouble has the same bits on any number of threads") {
  Scene scene;
  add(scene, ClothGrid{.columns = 120, .rows = 100, .spacing = 0.02, .areal_density = 2.0});
  scene.effects = {Gravity{}};
  scene.pin(0);
  scene.pin(119);
  scene.springs.stiffness[5000] = 1e8;
  std::uint64_t hash = 0;
  for (unsigned threads : sanitized ? std::vector{1u, 3u} : std::vector{1u, 2u, 5u}) {
    Settings settings = watched(OnTrouble::halve);
    settings.threads = threads;
    settings.step = 5e-4;
    Simulation<float> simulation(scene, settings);
    REQUIRE(simulation.step(40).ok());
    REQUIRE(simulation.plan().substeps > 1);
    if (threads > 1) CHECK(simulation.state_hash() == hash);
    hash = simulation.state_hash();
  }
}

TEST_CASE("where halving does not help the run stops") {
  Scene scene = hung_cloth(8, 8);
  scene.effects.push_back(Field{[](const Vec3&, double t) { return Vec3(0, t > 5.5e-3 ? NAN : 0.0, 0); }});
  Settings settings = watched(OnTrouble::halve);
  Simulation<float> simulation(scene, settings);
  const Report report = simulation.step(20);
  CHECK_FALSE(report.ok());
  CHECK((report.flags & flag_not_finite) != 0);
  CHECK(report.steps_taken == 6);
  CHECK(report.step == 7);
  CHECK(simulation.plan().substeps == 1024);
}

TEST_CASE("who wants only to be told is, and the run goes on until a value is not finite") {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  scene.add_particle(1.0, {1.01, 0, 0});
  scene.add_spring(0, 1, 100.0, 1.0);
  Settings settings = watched(OnTrouble::tell);
  settings.step = 1.002 * largest_stable_step(scene, SymplecticEuler{});
  Simulation<float> simulation(scene, settings);
  const Report first = simulation.step(700);
  CHECK(first.ok());
  CHECK(first.flags == flag_energy_grew);
  CHECK(first.message().find("the run goes on") != std::string::npos);
  CHECK(first.steps_taken == 700);
  const Report last = simulation.step(100'000);
  CHECK_FALSE(last.ok());
  CHECK((last.flags & flag_not_finite) != 0);
}

TEST_CASE_TEMPLATE("velocities of the last good state are finite, however large the forces there", Real,
                   float, double) {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  scene.add_particle(1.0, {1.1, 0.2, 0.0});
  scene.add_spring(0, 1, 1e4, 1.0);
  const Settings settings{
      .method = Verlet{}, .step = 1.0, .unstable_step = UnstableStep::take, .on_trouble = OnTrouble::ignore};
  Simulation<Real> simulation(scene, settings);
  REQUIRE((simulation.step(1000).flags & flag_not_finite) != 0);
  CHECK(simulation.steps() > 0);
  for (Index i = 0; i < 2; ++i) {
    CHECK(velocity(simulation, i).allFinite());
    CHECK(velocity(simulation, i).norm() > 0.0);
  }
  CHECK_NOTHROW(simulation.restore(simulation.snapshot()));
}

TEST_CASE("a callback decides, and is told what happened") {
  int asked = 0;
  Settings settings = watched(OnTrouble::ignore);
  settings.on_trouble = OnTrouble::stop;
  settings.decide_on_trouble = [&](const Report& report) {
    CHECK((report.flags & (flag_energy_grew | flag_not_finite)) != 0);
    CHECK(report.first_bad_particle != Report::none);
    return ++asked == 1 ? OnTrouble::halve : OnTrouble::stop;
  };
  Simulation<double> simulation(cloth_with_stiff_spring(), settings);
  CHECK_FALSE(simulation.step(5000).ok());
  CHECK(asked == 2);
  CHECK(simulation.plan().substeps == 2);
}

TEST_CASE("who takes steps as they are has nothing watched, and pays nothing") {
  const Settings taken{.step = 1e-3, .unstable_step = UnstableStep::take};
  Settings ignoring{.step = 1e-3, .on_trouble = OnTrouble::ignore};
  const Scene scene = hung_cloth(40, 40);
  const std::size_t watched_bytes = Simulation<float>(scene, {.step = 1e-3}).plan().state_bytes;
  CHECK(Simulation<float>(scene, taken).plan().state_bytes ==
        Simulation<float>(scene, ignoring).plan().state_bytes);
  CHECK(Simulation<float>(scene, taken).plan().state_bytes < watched_bytes);
  Simulation<float> unstable(cloth_with_stiff_spring(), taken);
  CHECK(unstable.step(100'000).flags == flag_not_finite);
}

TEST_CASE("methods that let oscillations grow are told of, and stopped before they explode") {
  for (const Method& method : {Method(ExplicitEuler{}), Method(Midpoint{}), Method(Heun{})}) {
    Scene scene = hung_cloth(12, 12);
    scene.effects = {Gravity{}};
    Simulation<double> simulation(scene, {.method = method, .step = 4e-3});
    const Report first = simulation.step(2);
    CHECK(first.ok());
    CHECK((first.flags & flag_oscillations_grow) != 0);
    CHECK(first.message().find("let") != std::string::npos);
    const Report report = simulation.step(100'000);
    REQUIRE_FALSE(report.ok());
    CHECK((report.flags & (flag_energy_grew | flag_restored)) == (flag_energy_grew | flag_restored));
    CHECK(simulation.max_strain() < 100.0);
  }
  CHECK((Simulation<float>(hung_cloth(4, 4), {.step = 1e-3}).step().flags & flag_oscillations_grow) == 0);
}

TEST_CASE_TEMPLATE("nothing is found in runs that go well, whatever puts energy into them", Real, float,
                   double) {
  for (const Scene& scene : {busy_scene(), hung_cloth(16, 16), one_particle()}) {
    for (const Method& method :
         {Method(SymplecticEuler{}), Method(Verlet{}), Method(RungeKutta4{}), Method(BlanesMoan{})}) {
      for (double share : {0.3, 0.999}) {
        CAPTURE(to_string(method));
        CAPTURE(share);
        const double longest = largest_stable_step(scene, method);
        const double step = std::isfinite(longest) ? share * longest : 1e-3;
        Simulation<Real> simulation(scene, {.method = method, .step = step});
        for (int i = 0; i < (sanitized ? 6 : 60); ++i) {
          const Report report = simulation.step(37);
          REQUIRE(report.flags == flag_none);
          simulation.apply_impulse(Index(i % simulation.particle_count()), Vec3(0.02, 0.01 * i, 0));
        }
      }
    }
  }
}

TEST_CASE("an oscillation at the edge of stability swings, and is left alone") {
  for (double share : {0.9, 0.99, 0.999, 0.99999}) {
    Scene scene;
    scene.add_particle(1.0, Vec3::Zero());
    scene.add_particle(1.0, {1.001, 0, 0});
    scene.add_spring(0, 1, 100.0, 1.0);
    const double longest = largest_stable_step(scene, SymplecticEuler{});
    Simulation<double> simulation(
        scene, {.step = share * longest, .unstable_step = UnstableStep::take, .on_trouble = OnTrouble::stop});
    CHECK(simulation.plan().substeps == 1);
    CHECK(simulation.step(200'000).flags == flag_none);
  }
}

TEST_CASE("a pin that is jerked about feeds a cloth as much as it can, and nothing is found") {
  for (double speed : {1.0, 30.0}) {
    Scene scene = hung_cloth(10, 10);
    std::vector<Keyframe> path;
    for (int i = 0; i < 200; ++i) path.push_back({i * 0.01, Vec3(0, i % 2 * 0.01 * speed, 0)});
    scene.pin(55, path);
    Simulation<double> simulation(scene, {.step = 1e-3});
    for (int i = 0; i < 200; ++i) REQUIRE(simulation.step(10).flags == flag_none);
  }
}
