#include <doctest/doctest.h>

#include <hooke/hooke.h>

#include "effects/forces_of_scene.h"

using namespace hooke;
using namespace hooke::test;

namespace {

Scene stiffening_sheet(double quadratic, double cubic) {
  Scene scene;
  add(scene, ClothGrid{.columns = 9, .rows = 7, .spacing = 0.1});
  scene.effects = {StiffeningSprings{quadratic, cubic}};
  return scene;
}

}  // namespace

TEST_CASE("stiffening springs: energy, force and derivative agree, stretched and pressed") {
  for (const double scale : {0.8, 1.0, 1.3}) {
    CAPTURE(scale);
    ForcesOfScene scene(stiffening_sheet(3.0, 20.0));
    scene.set_positions(scale * scene.positions());
    scene.shake(0.01, 0.0, 1);
    const Eigen::VectorXd both = scene.forces_at_time(0.0);
    Scene springs = stiffening_sheet(0.0, 0.0);
    ForcesOfScene linear(springs);
    linear.set_positions(scene.positions());
    const Eigen::VectorXd force = both - linear.forces_at_time(0.0);
    CHECK((forces_from_energy(scene, 1e-5) - force).norm() < 1e-6 * force.norm());

    const Eigen::VectorXd direction = random_direction(scene.state().size(), 2);
    const Eigen::VectorXd product = scene.product(direction, {1.0, 0.0}, Curvature::exact);
    const Eigen::VectorXd change =
        product_from_forces(scene, direction, 1e-6) - product_from_forces(linear, direction, 1e-6);
    CHECK((change - product).norm() < 1e-6 * product.norm());
    CHECK(direction.dot(scene.product(direction, {1.0, 0.0}, Curvature::convex)) >= 0.0);
    const auto [sum, moment] = force_and_moment(scene.positions(), force);
    CHECK(sum.norm() < 1e-12 * force.norm());
    CHECK(moment.norm() < 1e-12 * force.norm());
  }
}

TEST_CASE("stiffening springs: a weight hangs where the curve says, by an explicit and an implicit method") {
  // k l0 (s + q s^2 + c s^3) = m g at s = 1/2.
  const double k = 100.0, rest = 0.5, q = 2.0, c = 4.0, s = 0.5;
  const double weight = k * rest * (s + q * s * s + c * s * s * s);
  for (const Method& method :
       {Method(SymplecticEuler{}), Method(BackwardEuler{}), Method(VertexBlockDescent{})}) {
    CAPTURE(to_string(method));
    Scene scene;
    scene.add_particle(1.0, Vec3::Zero());
    scene.add_particle(weight / 10.0, Vec3(0, -rest, 0));
    scene.add_spring(0, 1, k, rest, 20.0);
    scene.pin(0);
    scene.effects = {Gravity{{0, -10, 0}}, StiffeningSprings{q, c, {0}}};
    Simulation<double> simulation(scene, {.method = method, .step = 2e-3});
    REQUIRE(simulation.step(4000).ok());
    std::vector<Vec3> x(2);
    simulation.copy_positions(x[0].data(), sizeof(Vec3));
    CHECK(x[1].y() == doctest::Approx(-rest * (1.0 + s)).epsilon(1e-4));
  }
}

TEST_CASE("stiffening springs with coefficients zero give the same bits as none") {
  Scene scene = stiffening_sheet(0.0, 0.0);
  scene.particles.position[5].z() += 0.05;
  Simulation<double> with(scene, {.method = BackwardEuler{}, .step = 1e-3});
  scene.effects.clear();
  Simulation<double> without(scene, {.method = BackwardEuler{}, .step = 1e-3});
  REQUIRE(with.step(10).ok());
  REQUIRE(without.step(10).ok());
  CHECK(with.state_hash() == without.state_hash());
}

TEST_CASE("stiffening springs: faults") {
  Scene scene = stiffening_sheet(-1.0, 0.0);
  CHECK(validate(scene)[0].message().find("quadratic is -1") != std::string::npos);
  scene = stiffening_sheet(1.0, 0.0);
  scene.springs.rest_length[7] = 0.0;
  scene.effects = {StiffeningSprings{1.0, 0.0, {7}}};
  REQUIRE(!validate(scene).empty());
  CHECK(validate(scene)[0].message().find("spring 7 has no rest length") != std::string::npos);
}
