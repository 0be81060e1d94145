#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include <hooke/hooke.h>

#include "effects/forces_of_scene.h"

using namespace hooke;
using namespace hooke::test;

namespace {

std::vector<Index> all_springs(const Scene& scene) {
  std::vector<Index> all(scene.springs.size());
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

Scene sheet_of_cables(double damping) {
  Scene scene;
  add(scene, ClothGrid{.columns = 9, .rows = 7, .spacing = 0.1, .damping = damping});
  scene.effects = {Cables{all_springs(scene)}};
  return scene;
}

}  // namespace

TEST_CASE("cables: energy, force and derivative agree, and forces have no sum or moment") {
  ForcesOfScene scene(sheet_of_cables(0.0));
  scene.shake(0.03, 0.0, 1);
  const Eigen::VectorXd force = scene.forces_at_time(0.0);
  REQUIRE(force.norm() > 1.0);
  CHECK((forces_from_energy(scene, 1e-7) - force).norm() < 1e-6 * force.norm());
  const Eigen::VectorXd direction = random_direction(scene.state().size(), 2);
  for (const Curvature curvature : {Curvature::exact, Curvature::convex}) {
    const Eigen::VectorXd product = scene.product(direction, {1.0, 0.0}, curvature);
    CHECK((product_from_forces(scene, direction, 1e-7) - product).norm() < 1e-5 * product.norm());
    CHECK(direction.dot(product) > 0.0);
  }
  const auto [sum, moment] = force_and_moment(scene.positions(), force);
  CHECK(sum.norm() < 1e-13 * force.norm());
  CHECK(moment.norm() < 1e-13 * force.norm());
}

TEST_CASE("cables: what is slack has exactly no force, whatever its speed; what is taut is as a spring") {
  ForcesOfScene slack(sheet_of_cables(0.5));
  slack.set_positions(0.9 * slack.positions());
  slack.shake(0.0, 2.0, 3);
  CHECK(slack.forces_at_time(0.0).cwiseAbs().maxCoeff() == 0.0);

  Scene springs = sheet_of_cables(0.5);
  springs.effects.clear();
  ForcesOfScene taut(sheet_of_cables(0.5)), linear(springs);
  for (ForcesOfScene* scene : {&taut, &linear}) {
    scene->set_positions(1.5 * scene->positions());
    scene->shake(0.0, 0.1, 4);
  }
  const Eigen::VectorXd force = linear.forces_at_time(0.0);
  CHECK((taut.forces_at_time(0.0) - force).norm() < 1e-12 * force.norm());
}

TEST_CASE("cables: none named gives the same bits as no effect") {
  Scene scene = sheet_of_cables(0.1);
  scene.particles.position[5].z() += 0.05;
  scene.effects.clear();
  for (const Method& method : {Method(SymplecticEuler{}), Method(BackwardEuler{}), Method(Xpbd{})}) {
    Simulation<double> without(scene, {.method = method, .step = 1e-4});
    Scene with_none = scene;
    with_none.effects = {Cables{}};
    Simulation<double> with(with_none, {.method = method, .step = 1e-4});
    REQUIRE(without.step(20).ok());
    REQUIRE(with.step(20).ok());
    CHECK(with.state_hash() == without.state_hash());
  }
}

TEST_CASE("cables: a hanging chain of them lies as one of springs does") {
  // The elastic chain in closed form: sag 0.3002856492 m.
  constexpr Index links = 20;
  for (const Method& method :
       {Method(SymplecticEuler{}), Method(BackwardEuler{}), Method(Xpbd{.substeps = 20})}) {
    CAPTURE(to_string(method));
    Scene scene;
    for (Index i = 0; i <= links; ++i) {
      const double s = double(i) / links;
      scene.add_particle(0.05, Vec3(s, -1.2 * s * (1.0 - s), 0.0));
    }
    for (Index i = 0; i < links; ++i) scene.add_spring(i, i + 1, 1e4, 0.06, 5.0);
    scene.pin(0);
    scene.pin(links);
    scene.effects = {Gravity{}, Drag{0.3}, Cables{all_springs(scene)}};
    Simulation<double> simulation(scene, {.method = method, .step = 5e-4});
    REQUIRE(simulation.step(8000).ok());
    std::vector<Vec3> x(links + 1);
    simulation.copy_positions(x[0].data(), sizeof(Vec3));
    CHECK(x[links / 2].y() == doctest::Approx(-0.3002856492).epsilon(2e-3));
  }
}

TEST_CASE("cables: faults") {
  Scene scene = sheet_of_cables(0.0);
  const auto fault = [&](std::vector<Effect> effects) {
    scene.effects = std::move(effects);
    const auto faults = validate(scene);
    REQUIRE(!faults.empty());
    return faults[0].message();
  };
  CHECK(fault({Cables{{0, 99999}}}).find("springs[1]") != std::string::npos);
  CHECK(fault({Cables{{3, 3}}}).find("names spring 3 twice") != std::string::npos);
  CHECK(fault({Cables{{3}}, StiffeningSprings{.quadratic = 1.0}}).find("another law") != std::string::npos);
  CHECK(fault({Plasticity{.rate = 1.0}, Cables{{4}}}).find("by plasticity") != std::string::npos);
}
