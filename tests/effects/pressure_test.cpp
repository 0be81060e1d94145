#include <doctest/doctest.h>

#include <cmath>

#include <hooke/hooke.h>

#include "effects/forces_of_scene.h"
#include "effects/sphere_scene.h"
#include "text.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// What a sphere is pushed outwards with, over its area [Pa].
double pressure_on(ForcesOfScene& sphere, double area) {
  const Eigen::VectorXd forces = sphere.forces_at_time(0.0), x = sphere.positions();
  double sum = 0.0;
  for (Eigen::Index i = 0; i < x.size(); i += 3)
    sum += forces.segment<3>(i).dot(x.segment<3>(i).normalized());
  return sum / area;
}

/// The sum over triangles of their area times the cosine to the direction from the centre.
double projected_area(const Scene& scene) {
  double sum = 0.0;
  const auto& x = scene.particles.position;
  for (const auto& [a, b, c] : scene.triangles) {
    const Vec3 sixth = (x[b] - x[a]).cross(x[c] - x[a]) / 6.0;
    sum += sixth.dot(x[a].normalized() + x[b].normalized() + x[c].normalized());
  }
  return sum;
}

void check_derivatives(const Effect& effect, double tolerance) {
  Scene ball = sphere_scene(2, 0.5, 0.0, {3.0, -2.0, 1.0});
  ball.effects = {effect};
  ForcesOfScene scene(ball);
  scene.shake(0.03, 0.0, 5);
  const Eigen::VectorXd force = scene.forces_at_time(0.0);
  CHECK((forces_from_energy(scene, 1e-5) - force).norm() < tolerance * force.norm());
  const Eigen::VectorXd direction = random_direction(scene.state().size(), 6);
  const Eigen::VectorXd exact = scene.product(direction, {1.0, 0.0}, Curvature::exact);
  CHECK((product_from_forces(scene, direction, 1e-6) - exact).norm() < 1e-6 * exact.norm());
  CHECK(direction.dot(scene.product(direction, {1.0, 0.0}, Curvature::convex)) >= 0.0);
  const auto [sum, moment] = force_and_moment(scene.positions(), force);
  CHECK(sum.norm() < 1e-12 * force.norm());
  CHECK(moment.norm() < 1e-11 * force.norm());
}

}  // namespace

TEST_CASE("gas obeys its law: pressure times volume to the power stays as it is") {
  for (const double exponent : {0.0, 1.0, 1.4}) {
    CAPTURE(exponent);
    Scene scene = sphere_scene(3, 1.0, 0.0);
    scene.effects = {Pressure{.overpressure = 5e4, .ambient = 1e5, .exponent = exponent}};
    const double area = projected_area(scene);
    ForcesOfScene sphere(scene);
    const Eigen::VectorXd start = sphere.positions();
    for (const double scale : {0.8, 1.0, 1.3}) {
      CAPTURE(scale);
      sphere.set_positions(scale * start);
      const double expected = 1.5e5 * std::pow(scale * scale * scale, -exponent) - 1e5;
      CHECK(pressure_on(sphere, scale * scale * area) == doctest::Approx(expected).epsilon(1e-12));
    }
  }
}

TEST_CASE("gas and volume: energy, force and derivative agree, and there is no sum or moment") {
  check_derivatives(Pressure{.overpressure = 5e4, .ambient = 1e5, .exponent = 1.0}, 1e-6);
  check_derivatives(Pressure{.overpressure = 2e4, .ambient = 1e4, .exponent = 1.4}, 1e-6);
  check_derivatives(Volume{.bulk_modulus = 1e4, .ratio = 1.2}, 1e-6);
}

TEST_CASE("a balloon is blown up to where its skin balances the gas, by any method alike") {
  Scene scene = sphere_scene(2, 0.1, 40.0);
  scene.effects = {Pressure{.overpressure = 500.0, .ambient = 1000.0}, Drag{0.2}};
  std::vector<double> radii;
  for (const Method& method : {Method(SymplecticEuler{}), Method(Verlet{}), Method(BackwardEuler{}),
                               Method(ProjectiveDynamics{.iterations = 50}), Method(Xpbd{.substeps = 40}),
                               Method(VertexBlockDescent{.iterations = 100})}) {
    CAPTURE(to_string(method));
    Simulation<double> simulation(scene, {.method = method, .step = 5e-3});
    for (int i = 0; i < 40; ++i) REQUIRE(simulation.step(10).ok());
    CHECK(simulation.energy().kinetic < 1e-8);
    const auto state = simulation.state();
    radii.push_back(Vec3(state.x[0], state.y[0], state.z[0]).norm());
    CHECK(radii.back() > 0.105);
    CHECK(radii.back() == doctest::Approx(radii.front()).epsilon(1e-3));
  }
}

TEST_CASE("what does not enclose a volume is refused, with the edge that is open") {
  Scene scene = sphere_scene(1, 1.0, 1.0);
  scene.effects = {Pressure{.overpressure = 1.0}};
  const auto fault = [&] {
    const auto faults = validate(scene);
    REQUIRE(faults.size() == 1);
    return faults[0].message();
  };
  SUBCASE("open") {
    scene.triangles.pop_back();
    CHECK(contains(fault(), "effects[0] (pressure): the triangles are not closed: the edge from particle"));
  }
  SUBCASE("inside out") {
    for (Triangle& triangle : scene.triangles) std::swap(triangle[0], triangle[1]);
    CHECK(contains(fault(), "the triangles enclose a volume of -"));
  }
  SUBCASE("one turned over") {
    std::swap(scene.triangles[3][0], scene.triangles[3][1]);
    CHECK(contains(fault(), "go through it in the same direction"));
  }
  SUBCASE("none") {
    scene.triangles.clear();
    CHECK(contains(fault(), "the scene has no triangles"));
  }
  SUBCASE("a triangle that is not there") {
    scene.effects = {Volume{.bulk_modulus = 1.0, .triangles = {500}}};
    CHECK(contains(fault(), "effects[0] (volume): triangles[0] is 500"));
  }
  SUBCASE("less than a vacuum") {
    scene.effects = {Pressure{.overpressure = -2e5}};
    CHECK(contains(fault(), "give an overpressure of at least minus the ambient pressure"));
  }
}

TEST_CASE("a closed part of a scene can be named") {
  Scene scene = sphere_scene(1, 1.0, 1.0);
  std::vector<Index> ball(scene.triangles.size());
  for (Index i = 0; i < ball.size(); ++i) ball[i] = i;
  const Index corner = scene.add_particle(1.0, {9, 9, 9});
  scene.triangles.push_back({0, 1, corner});
  scene.effects = {Volume{.bulk_modulus = 1.0, .triangles = ball}};
  CHECK(validate(scene).empty());
}

TEST_CASE("volume of no modulus, and gas at the pressure of outside without a change, leave the bits alone") {
  Scene bare = sphere_scene(2, 1.0, 100.0);
  bare.particles.position[7] *= 1.2;
  Scene with = bare;
  with.effects = {Volume{}};
  Simulation<float> without_it(bare, {.step = 1e-3}), with_it(with, {.step = 1e-3});
  REQUIRE(without_it.step(50).ok());
  REQUIRE(with_it.step(50).ok());
  CHECK(without_it.state_hash() == with_it.state_hash());
}
