// Projective dynamics solves the equations of backward Euler: converged, it comes to where Newton's method
// comes; before, each iteration comes nearer.

#include <doctest/doctest.h>

#include <limits>
#include <random>
#include <string>
#include <vector>

#include "irregular_mesh.h"
#include "scenes.h"

using namespace hooke;

namespace {

constexpr double step = 0.002;  // [s]

/// A cloth whose particles are off their places, by up to a third of a spring by default: some springs are
/// stretched, others pressed.
Scene crumpled_cloth(double damping = 0.0, double furthest = 0.007) {
  Scene scene = test::hung_cloth(12, 9, damping);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> off(-furthest, furthest);
  for (Vec3& x : scene.particles.position) x += Vec3(off(random), off(random), off(random));
  scene.particles.velocity.assign(scene.particles.size(), Vec3(0.3, -0.2, 0.1));
  return scene;
}

/// A cloth without pins that falls onto the ground: some particles are below it, and others come there in the
/// step. It is less crumpled, as corners without a pin would have two places to snap to.
Scene landing_cloth() {
  Scene scene = crumpled_cloth(0.01, 0.003);
  scene.pins.clear();
  Vec3 lowest = scene.particles.position[0], highest = lowest;
  for (const Vec3& x : scene.particles.position) {
    lowest = lowest.cwiseMin(x);
    highest = highest.cwiseMax(x);
  }
  scene.effects = {Gravity{}, Drag{.coefficient = 1e-3},
                   GroundPlane{.normal = Vec3(0.1, 1.0, 0.0),
                               .height = 0.5 * (lowest.y() + highest.y()),
                               .stiffness = 50.0,
                               .damping = 0.01}};
  return scene;
}

std::vector<Vec3> positions_after(const Scene& scene, const Method& method, int steps = 1) {
  Simulation<double> simulation(scene, {.method = method, .step = step});
  const Report report = simulation.step(std::uint64_t(steps));
  INFO(report.message());
  REQUIRE(report.message().empty());
  REQUIRE(report.ok());
  std::vector<Vec3> positions;
  for (Index i = 0; i < scene.particles.size(); ++i) positions.push_back(test::position(simulation, i));
  return positions;
}

double largest_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

constexpr BackwardEuler newton{.tolerance = 1e-13, .most_iterations = 1000};

ProjectiveDynamics converged(std::uint64_t history) {
  return {.iterations = 100000, .tolerance = 1e-13, .history = history};
}

/// Lengths here are about 1 m.
void check_same_as_newton(const Scene& scene) {
  const std::vector<Vec3> expected = positions_after(scene, newton, 2);
  for (std::uint64_t history : {0u, 1u, 5u}) {
    CAPTURE(history);
    CHECK(largest_distance(positions_after(scene, converged(history), 2), expected) < 1e-9);
  }
}

}  // namespace

TEST_CASE("Converged, projective dynamics takes Newton's step") {
  SUBCASE("of a cloth, stretched and pressed, pinned, in gravity and drag") {
    check_same_as_newton(crumpled_cloth());
  }
  SUBCASE("with damped springs") {
    check_same_as_newton(crumpled_cloth(0.02));
  }
  SUBCASE("on the ground") {
    check_same_as_newton(landing_cloth());
  }
  SUBCASE("with other pins, one of which moves") {
    Scene scene = crumpled_cloth();
    scene.pins.clear();
    scene.pin(40, {{0.0, Vec3::Zero()}, {1.0, Vec3(0.5, 0.0, 0.0)}});
    scene.pin(41);
    check_same_as_newton(scene);
  }
  SUBCASE("of particles without springs") {
    Scene scene = crumpled_cloth();
    scene.springs = {};
    check_same_as_newton(scene);
  }
  SUBCASE("of one particle") {
    Scene scene = test::one_particle();
    scene.effects = {Gravity{}, Drag{.coefficient = 0.5}};
    check_same_as_newton(scene);
  }
  SUBCASE("of parts that nothing joins, one of them free") {
    Scene scene = crumpled_cloth();
    const Index a = scene.add_particle(0.1, Vec3(0.5, 0.5, 0.0), Vec3(1.0, 0.0, 0.0));
    const Index b = scene.add_particle(0.2, Vec3(0.55, 0.5, 0.1));
    scene.add_spring(a, b, 200.0, 0.2, 0.1);
    check_same_as_newton(scene);
  }
  SUBCASE("of an irregular mesh, whose particles are renumbered") {
    Scene scene;
    add(scene, test::irregular_mesh(9));
    scene.pin(0);
    scene.effects = {Gravity{}};
    check_same_as_newton(scene);
  }
  SUBCASE("where all particles are pinned") {
    Scene scene = crumpled_cloth();
    scene.pins.clear();
    for (Index i = 0; i < scene.particles.size(); ++i) scene.pin(i);
    check_same_as_newton(scene);
  }
}

TEST_CASE("Each iteration lowers the potential that backward Euler minimises") {
  Scene scene = crumpled_cloth();
  scene.effects = {Gravity{}};
  // 1/2 |x - y|^2 M + h^2 E, with y where the particles would be but for springs.
  const auto potential = [&](const std::vector<Vec3>& x) {
    double sum = 0.0;
    std::vector<bool> pinned(x.size());
    for (const Pin& pin : scene.pins) pinned[pin.particle] = true;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Vec3 y = scene.particles.position[i] + step * scene.particles.velocity_of(i) +
                     step * step * Vec3(0.0, -9.81, 0.0);
      if (!pinned[i]) sum += 0.5 * scene.particles.mass[i] * (x[i] - y).squaredNorm();
    }
    const Springs& springs = scene.springs;
    for (std::size_t s = 0; s < springs.size(); ++s) {
      const double stretch = (x[springs.first[s]] - x[springs.second[s]]).norm() - springs.rest_length[s];
      sum += 0.5 * step * step * springs.stiffness[s] * stretch * stretch;
    }
    return sum;
  };
  const double least = potential(positions_after(scene, newton));
  for (std::uint64_t history : {0u, 5u}) {
    double before = std::numeric_limits<double>::infinity();
    for (std::uint64_t iterations = 1; iterations <= 15; ++iterations) {
      CAPTURE(history);
      CAPTURE(iterations);
      const double now = potential(positions_after(scene, ProjectiveDynamics{iterations, 0.0, history}));
      CHECK(now < before);
      CHECK(now > least);
      before = now;
    }
  }
}

TEST_CASE("Iterations are as many as asked for, or fewer where a tolerance is met") {
  const Scene scene = crumpled_cloth();
  Simulation<double> ten(scene, {.method = ProjectiveDynamics{.iterations = 10}, .step = step});
  CHECK(ten.step().solver_iterations == 10);
  Simulation<double> fewer(
      scene, {.method = ProjectiveDynamics{.iterations = 1000, .tolerance = 1e-6}, .step = step});
  const Report report = fewer.step();
  CHECK(report.ok());
  CHECK(report.solver_iterations > 1);
  CHECK(report.solver_iterations < 200);
  CHECK(report.residual <= 1e-6);
}

TEST_CASE("A tolerance that the iterations do not meet is reported") {
  Simulation<double> simulation(crumpled_cloth(), {.method = ProjectiveDynamics{2, 1e-9}, .step = step});
  const Report report = simulation.step();
  CHECK((report.flags & flag_not_converged) != 0);
}

TEST_CASE("A force that is not finite is reported by projective dynamics") {
  Scene scene = crumpled_cloth();
  scene.effects = {
      Field{[](const Vec3&, double) { return Vec3(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0); }}};
  Simulation<double> simulation(scene, {.method = ProjectiveDynamics{}, .step = step});
  CHECK_FALSE(simulation.step().message().empty());
}

TEST_CASE("Faults in the settings of projective dynamics are named") {
  const auto fault = [](const ProjectiveDynamics& method) {
    const std::vector<Fault> faults = validate(test::one_particle(), {.method = method});
    return faults.size() == 1 ? faults[0].message() : std::string();
  };
  CHECK(fault({}).empty());
  CHECK(fault({.iterations = 0}).find("iterations is 0") != std::string::npos);
  CHECK(fault({.tolerance = -1.0}).find("tolerance is -1") != std::string::npos);
  CHECK(fault({.history = 101}).find("history is 101") != std::string::npos);
}
