#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <hooke/hooke.h>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

template <class Real>
bool finite(const Simulation<Real>& simulation) {
  const StateView<Real> s = simulation.state();
  for (std::size_t i = 0; i < simulation.particle_count(); ++i) {
    for (Real value : {s.x[i], s.y[i], s.z[i], s.vx[i], s.vy[i], s.vz[i]}) {
      if (!std::isfinite(value)) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE_TEMPLATE("an unstable step ends with a report, and the last good state is kept", Real, float,
                   double) {
  for (auto accumulation : accumulations) {
    Simulation<Real> simulation(
        hung_cloth(20, 20),
        {.step = 0.1, .unstable_step = UnstableStep::take, .accumulation = accumulation, .threads = 2});
    const Report report = simulation.step(100'000);
    REQUIRE_FALSE(report.ok());
    CHECK(report.step == report.steps_taken + 1);
    CHECK(report.step == simulation.steps() + 1);
    REQUIRE(report.first_bad_particle < simulation.particle_count());
    const std::string message = report.message();
    CHECK(message.find("step " + std::to_string(report.step)) != std::string::npos);
    CHECK(message.find("particle " + std::to_string(report.first_bad_particle)) != std::string::npos);
    CHECK(finite(simulation));
    CHECK(simulation.time() == doctest::Approx(0.1 * double(report.steps_taken)));

    const std::uint64_t hash = simulation.state_hash();
    const Report again = simulation.step();
    CHECK(again.steps_taken == 0);
    CHECK(again.step == report.step);
    CHECK(again.first_bad_particle == report.first_bad_particle);
    CHECK(simulation.state_hash() == hash);
  }
}

TEST_CASE("a force that is not a number is reported by every method, and positions stay finite") {
  for (const Method& method : all_methods) {
    CAPTURE(to_string(method));
    Scene scene = hung_cloth(8, 8);
    const Vec3 place = scene.particles.position[29];
    scene.effects.push_back(Field{[place](const Vec3& x, double t) {
      return Vec3(0.0, t > 0.0045 && (x - place).norm() < 0.005 ? NAN : 0.0, 0.0);
    }});
    Simulation<double> simulation(scene, {.method = method, .step = 1e-3});
    const Report report = simulation.step(10);
    CHECK_FALSE(report.ok());
    CHECK((report.flags & flag_not_finite) != 0);
    CHECK(report.steps_taken >= 3);
    // In a method of several stages, or iterations over neighbours, it has spread before anyone looks.
    CHECK(report.first_bad_particle < scene.particles.size());
    const bool sees_it_at_once = std::holds_alternative<SymplecticEuler>(method) ||
                                 std::holds_alternative<BackwardEuler>(method) ||
                                 std::holds_alternative<ProjectiveDynamics>(method);
    if (sees_it_at_once) CHECK(report.first_bad_particle == 29);
    std::vector<double> positions(3 * scene.particles.size());
    simulation.copy_positions(positions.data(), 3 * sizeof(double));
    for (const double x : positions) CHECK(std::isfinite(x));
  }
}

TEST_CASE("interpolation stays finite after a bad step") {
  Scene scene = one_particle();
  scene.effects = {Field{[](const Vec3&, double t) { return t > 0.25 ? Vec3(NAN, 0, 0) : Vec3(1, 0, 0); }}};
  Simulation<double> simulation(scene, {.step = 0.1});
  CHECK_FALSE(simulation.step(10).ok());
  double between[3];
  simulation.copy_positions(between, sizeof between, 0.5);
  CHECK(std::isfinite(between[0]));
}

TEST_CASE("the first bad particle is the lowest of the user's numbers, on any number of threads") {
  for (unsigned threads : {1u, 4u}) {
    Scene scene;
    for (int i = 0; i < 5000; ++i) scene.add_particle(1.0, Vec3(i, 0, 0));
    scene.effects = {Field{[](const Vec3& x, double) { return Vec3(0, x.x() >= 1234 ? NAN : 0.0, 0); }}};
    Simulation<float> simulation(scene, {.threads = threads});
    CHECK(simulation.step().first_bad_particle == 1234);
  }
}

TEST_CASE("what a callback throws reaches the caller, and the state is as before") {
  for (const Method& method : all_methods) {
    for (auto accumulation : {Accumulation::gather, Accumulation::coloured}) {
      CAPTURE(to_string(method));
      if (!can_accumulate(method, accumulation)) continue;
      Scene scene = hung_cloth(20, 20), calm = scene;
      int calls_until_angry = -1;
      scene.effects.push_back(Field{[&](const Vec3&, double) -> Vec3 {
        if (calls_until_angry > 0 && --calls_until_angry == 0) throw std::runtime_error("from the field");
        return Vec3::Zero();
      }});
      const Settings settings{.method = method, .step = 1e-4, .accumulation = accumulation, .threads = 1};
      Simulation<float> simulation(scene, settings), reference(calm, settings);
      REQUIRE(simulation.step(10).ok());
      const Snapshot<float> before = simulation.snapshot();
      calls_until_angry = 137;
      CHECK_THROWS_WITH(simulation.step(), "from the field");
      CHECK(simulation.snapshot().positions == before.positions);
      CHECK(simulation.snapshot().velocities == before.velocities);
      CHECK(simulation.steps() == 10);
      simulation.restore(before);
      REQUIRE(simulation.step(10).ok());
      REQUIRE(reference.step(20).ok());
      CHECK(simulation.state_hash() == reference.state_hash());
    }
  }
}

TEST_CASE_TEMPLATE("coincident particles, zero rest length, no springs, one particle: no NaN", Real, float,
                   double) {
  Scene coincident;
  coincident.add_particle(1.0, {1, 1, 1});
  coincident.add_particle(1.0, {1, 1, 1});
  coincident.add_spring(0, 1, 1e3, 1.0, 5.0);
  Scene zero_rest = coincident;
  zero_rest.springs.rest_length[0] = 0.0;
  Scene nearly = coincident;
  nearly.particles.position[0] = {1.0 + 1e-12, 1, 1};  // the same place in float
  Scene denormal;
  denormal.add_particle(1.0, {0, 0, 0});
  denormal.add_particle(1.0, {1e-38, 0, 0});
  denormal.add_spring(0, 1, 1.0, 1.0, 1.0);
  Scene tiny_rest = coincident;
  tiny_rest.springs.rest_length[0] = 1e-38;
  for (const Scene& scene : {coincident, zero_rest, nearly, denormal, tiny_rest, one_particle()}) {
    for (auto accumulation : accumulations) {
      for (const Method& method : all_methods) {
        CAPTURE(to_string(method));
        if (!can_accumulate(method, accumulation)) continue;
        Simulation<Real> simulation(scene, {.method = method, .step = 1e-3, .accumulation = accumulation});
        CHECK(simulation.step(100).ok());
        CHECK(finite(simulation));
        CHECK(std::isfinite(simulation.energy().total()));
        CHECK(std::isfinite(simulation.max_strain()));
        CHECK(simulation.momentum().norm() < 1e-12);
      }
    }
  }
}

TEST_CASE("values that a float cannot hold are refused, with the remedy") {
  Scene scene = one_particle();
  scene.particles.mass[0] = 1e-300;
  CHECK_THROWS_WITH_AS(Simulation<float>{scene}, doctest::Contains("particle 0: mass is 1e-300 kg"),
                       SceneError);
  CHECK_NOTHROW(Simulation<double>{scene});
  scene.particles.mass[0] = 1.0;
  scene.add_particle(1.0, {1e200, 0, 0});
  scene.add_spring(0, 1, 1e100, 1.0);
  try {
    Simulation<float> simulation(scene, {.unstable_step = UnstableStep::take});
    FAIL("accepted");
  } catch (const SceneError& error) {
    CHECK(error.faults().size() == 2);
    CHECK(error.faults()[1].remedy.find("double") != std::string::npos);
  }
}

TEST_CASE("a pull that would overflow where two ends meet is refused") {
  Scene scene = one_particle();
  scene.add_particle(1.0, {1, 0, 0});
  scene.add_spring(0, 1, 1e12, 1e6);
  CHECK_THROWS_WITH_AS(Simulation<float>{scene},
                       doctest::Contains("spring 0: stiffness times rest length is 1e+18 N"), SceneError);
  scene.springs.rest_length[0] = 1e5;
  scene.particles.position[1] = scene.particles.position[0];
  CHECK(Simulation<float>(scene).step().ok());
}

TEST_CASE_TEMPLATE("a path that leads out of what Real can hold is refused", Real, float, double) {
  const double largest = double(std::numeric_limits<Real>::max());
  Scene far = one_particle(), fast = far;
  far.particles.position[0] = {0.9 * largest, 0, 0};
  far.pin(0, {{0.0, {0.9 * largest, 0, 0}}});
  fast.pin(0, {{0.0, {0, 0, 0}}, {1e-3, {0.5 * largest, 0, 0}}});
  CHECK_THROWS_WITH_AS(Simulation<Real>{far}, doctest::Contains("pin 0: position on its path"), SceneError);
  CHECK_THROWS_WITH_AS(Simulation<Real>{fast}, doctest::Contains("pin 0: speed on its path"), SceneError);
}

TEST_CASE("numbers that fade away to nothing do not slow the engine down") {
  // A spring of float subnormals in y: without flushing, each step is many times slower.
  const auto seconds = [](float tiny) {
    Scene scene;
    for (Index i = 0; i < 4096; ++i) scene.add_particle(1.0, {double(i), i % 2 * double(tiny), 0});
    for (Index i = 0; i + 1 < 4096; ++i) scene.add_spring(i, i + 1, 1e-3, 0.5);
    Simulation<float> simulation(scene, {.step = 1e-3, .threads = 1});
    double best = 1e9;
    for (int repeat = 0; repeat < 20; ++repeat) {
      const Report report = simulation.step(5);
      REQUIRE(report.ok());
      best = std::min(best, report.sweeps[0].seconds);
    }
    return best;
  };
  CHECK(seconds(1e-39f) < 2.0 * seconds(0.25f));
}

TEST_CASE("a pinned particle is never the bad one, whatever pulls at it") {
  Scene scene;
  scene.add_particle(1.0, {0, 0, 0});
  scene.add_particle(1.0, {1, 0, 0}, {1e30, 0, 0});
  scene.add_spring(0, 1, 1e30, 0.0);
  scene.pin(0);
  Simulation<float> simulation(scene, {.step = 1.0, .unstable_step = UnstableStep::take});
  const Report report = simulation.step(100);
  REQUIRE_FALSE(report.ok());
  CHECK(report.first_bad_particle == 1);
}
