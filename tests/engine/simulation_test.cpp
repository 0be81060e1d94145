#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "irregular_mesh.h"
#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

struct Vertex {
  float colour = 7.0f;
  float position[3] = {0, 0, 0};
  float normal[2] = {8.0f, 9.0f};
};

Scene irregular_cloth() {
  Scene scene;
  const MeshParticles cloth = add(scene, irregular_mesh(12));
  scene.pin(cloth.first);
  scene.effects = {Gravity{}};
  return scene;
}

}  // namespace

TEST_CASE("copies are in the user's numbering, with any stride, and touch nothing between") {
  const Scene scene = irregular_cloth();
  Simulation<float> simulation(scene, {.step = 1e-3});
  CHECK(simulation.plan().order.find("Cuthill") != std::string::npos);
  std::vector<Vertex> vertices(scene.particles.size());
  simulation.copy_positions(vertices[0].position, sizeof(Vertex));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      CHECK(vertices[i].position[axis] == float(scene.particles.position[i][axis]));
    }
    CHECK(vertices[i].colour == 7.0f);
    CHECK(vertices[i].normal[0] == 8.0f);
    CHECK(vertices[i].normal[1] == 9.0f);
  }
  REQUIRE(simulation.step(20).ok());
  std::vector<double> velocities(3 * vertices.size());
  simulation.copy_velocities(velocities.data(), 3 * sizeof(double));
  for (Index i = 0; i < vertices.size(); ++i) CHECK(velocities[3 * i + 1] == velocity(simulation, i).y());
}

TEST_CASE("interpolation goes from the state before to the newest") {
  Scene scene;
  scene.add_particle(1.0, {0, 0, 0}, {8, 0, 0});
  Simulation<double> simulation(scene, {.step = 0.125});
  REQUIRE(simulation.step(4).ok());
  double at[3];
  const auto x = [&](double share) {
    simulation.copy_positions(at, sizeof at, share);
    return at[0];
  };
  CHECK(x(1.0) == 4.0);
  CHECK(x(0.0) == 3.0);
  CHECK(x(0.25) == 3.25);
}

TEST_CASE("advance takes the steps that fit, and says how far the frame is past the last") {
  Scene scene;
  scene.add_particle(1.0, {0, 0, 0}, {1, 0, 0});
  Simulation<double> simulation(scene, {.step = 0.01, .max_steps_per_advance = 5});
  Report report = simulation.advance(0.025);
  CHECK(report.steps_taken == 2);
  CHECK(report.step == 2);
  CHECK(report.interpolation == doctest::Approx(0.5));
  CHECK(report.ok());
  CHECK(report.message().empty());
  report = simulation.advance(0.001);
  CHECK(report.steps_taken == 0);
  report = simulation.advance(10.0);
  CHECK(report.steps_taken == 5);
  CHECK((report.flags & flag_steps_dropped) != 0);
  CHECK(report.dropped_seconds > 9.9);
  CHECK(report.ok());
  CHECK(report.message().find("dropped") != std::string::npos);
  CHECK_THROWS_AS(simulation.advance(-1.0), std::invalid_argument);
  CHECK_THROWS_AS(simulation.advance(std::nan("")), std::invalid_argument);
  CHECK(simulation.steps() == 7);
}

TEST_CASE_TEMPLATE("a restored snapshot goes on with the same bits", Real, float, double) {
  const Scene scene = irregular_cloth();
  const Settings settings{.step = 1e-3};
  Simulation<Real> simulation(scene, settings);
  simulation.advance(0.0035);
  const Snapshot<Real> snapshot = simulation.snapshot();
  const std::uint64_t then = simulation.state_hash();
  REQUIRE(simulation.step(50).ok());
  const std::uint64_t later = simulation.state_hash();
  CHECK(later != then);

  simulation.restore(snapshot);
  CHECK(simulation.state_hash() == then);
  CHECK(simulation.steps() == 3);
  REQUIRE(simulation.step(50).ok());
  CHECK(simulation.state_hash() == later);

  Simulation<Real> other(scene, settings);
  other.restore(snapshot);
  REQUIRE(other.step(50).ok());
  CHECK(other.state_hash() == later);
  CHECK(other.snapshot().remainder == doctest::Approx(0.0005));
}

TEST_CASE("a snapshot that does not fit is refused and changes nothing") {
  Simulation<float> simulation(hung_cloth(5, 5), {.step = 1e-3});
  REQUIRE(simulation.step(5).ok());
  const std::uint64_t before = simulation.state_hash();
  Snapshot<float> wrong = simulation.snapshot();
  wrong.positions.pop_back();
  CHECK_THROWS_AS(simulation.restore(wrong), std::invalid_argument);
  wrong = simulation.snapshot();
  wrong.velocities[7] = std::numeric_limits<float>::infinity();
  CHECK_THROWS_WITH_AS(simulation.restore(wrong), doctest::Contains("particle 2"), std::invalid_argument);
  wrong = simulation.snapshot();
  wrong.remainder = 1.0;
  CHECK_THROWS_AS(simulation.restore(wrong), std::invalid_argument);
  CHECK(simulation.state_hash() == before);
}

TEST_CASE("an impulse is the same as an edited snapshot, with every method, springs damped and not") {
  const Vec3 impulse(1e-3, 2e-3, -3e-3);
  for (const Method& method : all_methods) {
    CAPTURE(to_string(method));
    Scene scene = irregular_cloth();
    scene.effects.push_back(Drag{1e-3});
    Simulation<double> pushed(scene, {.method = method, .step = 1e-3});
    REQUIRE(pushed.step(50).ok());
    Simulation<double> edited(scene, {.method = method, .step = 1e-3});
    const Vec3 momentum = pushed.momentum();

    auto snapshot = pushed.snapshot();
    for (int axis = 0; axis < 3; ++axis)
      snapshot.velocities[3 * 17 + std::size_t(axis)] += impulse[axis] / scene.particles.mass[17];
    edited.restore(snapshot);
    pushed.apply_impulse(17, impulse);
    CHECK((pushed.momentum() - momentum - impulse).norm() < 1e-13);
    CHECK((velocity(pushed, 17) - velocity(edited, 17)).norm() < 1e-14);

    REQUIRE(pushed.step(50).ok());
    REQUIRE(edited.step(50).ok());
    for (Index i = 0; i < scene.particles.size(); ++i)
      CHECK((position(pushed, i) - position(edited, i)).norm() <
            1e-6 * impulse.norm() / scene.particles.mass[17]);
  }
}

TEST_CASE("an impulse moves no pin, and one that cannot be used changes nothing") {
  const Scene scene = irregular_cloth();
  Simulation<float> simulation(scene, {.step = 1e-3});
  REQUIRE(simulation.step(3).ok());
  const std::uint64_t before = simulation.state_hash();
  simulation.apply_impulse(scene.pins[0].particle, {1, 2, 3});
  CHECK(simulation.state_hash() == before);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH_AS(simulation.apply_impulse(5, {0, infinity, 0}), doctest::Contains("particle 5"),
                       std::invalid_argument);
  CHECK_THROWS_AS(simulation.apply_impulse(5, {0, 1e38, 0}), std::invalid_argument);  // too much for a float
  CHECK_THROWS_AS(simulation.apply_impulse(Index(scene.particles.size()), {0, 1, 0}), std::out_of_range);
  CHECK(simulation.state_hash() == before);
}

TEST_CASE("every fault of scene and settings is thrown at once") {
  Scene scene = one_particle();
  scene.particles.mass[0] = -1.0;
  try {
    Simulation<float> simulation(scene, {.step = 0.0, .max_steps_per_advance = 0});
    FAIL("accepted");
  } catch (const SceneError& error) {
    CHECK(error.faults().size() == 3);
  }
  CHECK_THROWS_AS(Simulation<float>{Scene{}}, SceneError);
}

TEST_CASE("what the simulation knows of itself") {
  const Scene scene = hung_cloth(8, 9);
  const Simulation<float> simulation(scene, {.step = 0.5, .threads = 3});
  CHECK(simulation.particle_count() == 72);
  CHECK(simulation.spring_count() == scene.springs.size());
  CHECK(simulation.threads() == 3);
  CHECK(simulation.settings().step == 0.5);
  CHECK(simulation.time() == 0.0);
  CHECK_THROWS_AS(simulation.engine_index(72), std::out_of_range);
}

TEST_CASE("the largest strain is that of the most stretched spring with a rest length") {
  Scene scene;
  for (double x : {0.0, 1.5, 2.0, 4.0}) scene.add_particle(1.0, {x, 0, 0});
  scene.add_spring(0, 1, 1.0, 1.0);  // strain 0.5
  scene.add_spring(1, 2, 1.0, 1.0);  // strain -0.5
  scene.add_spring(2, 3, 1.0, 0.0);  // none
  for (auto accumulation : accumulations) {
    CHECK(Simulation<double>(scene, {.accumulation = accumulation}).max_strain() == doctest::Approx(0.5));
  }
  scene.springs.rest_length = {10.0, 2.0, 0.0};
  CHECK(Simulation<double>(scene).max_strain() == doctest::Approx(-0.75));
  CHECK(Simulation<double>(one_particle()).max_strain() == 0.0);
}

TEST_CASE("the time of step n is n times the step, also after a snapshot") {
  const double h = 1.0 / 60.0;
  Simulation<float> simulation(one_particle(), {.step = h}), other(one_particle(), {.step = h / 2});
  REQUIRE(simulation.step(1001).ok());
  CHECK(simulation.time() == 1001 * h);
  const auto snapshot = simulation.snapshot();
  REQUIRE(simulation.step(10).ok());
  simulation.restore(snapshot);
  REQUIRE(simulation.step(4).ok());
  CHECK(simulation.time() == 1005 * h);
  other.restore(snapshot);
  REQUIRE(other.step(2).ok());
  CHECK(other.time() == doctest::Approx(1002 * h).epsilon(1e-14));
}
