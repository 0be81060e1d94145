#include <doctest/doctest.h>

#include <hooke/hooke.h>

#include "effects/forces_of_scene.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// A grid without springs whose rows and columns bend, in an order that the engine keeps or not.
Scene bending_grid(Index columns, Index rows) {
  Scene scene;
  const GridParticles grid =
      add(scene,
          ClothGrid{.columns = columns, .rows = rows, .spacing = 0.1, .stretch = 0, .shear = 0, .bend = 0});
  LaplacianBending bending;
  const auto line = [&](Index a, Index b, Index c, double k) {
    bending.first.push_back(a);
    bending.middle.push_back(b);
    bending.last.push_back(c);
    bending.stiffness.push_back(k);
  };
  for (Index r = 0; r < rows; ++r) {
    for (Index c = 0; c < columns; ++c) {
      if (c > 0 && c + 1 < columns) line(grid.at(c - 1, r), grid.at(c, r), grid.at(c + 1, r), 2.0);
      if (r > 0 && r + 1 < rows) line(grid.at(c, r - 1), grid.at(c, r), grid.at(c, r + 1), 3.0 + 0.1 * c);
    }
  }
  scene.effects = {bending};
  return scene;
}

}  // namespace

TEST_CASE("Laplacian bending: energy, force and derivative agree") {
  ForcesOfScene scene(bending_grid(20, 7));
  scene.shake(0.05, 0.0, 1);
  const Eigen::VectorXd force = scene.forces_at_time(0.0);
  CHECK((forces_from_energy(scene, 1e-4) - force).norm() < 1e-8 * force.norm());

  const Eigen::VectorXd direction = random_direction(scene.state().size(), 2);
  const Eigen::VectorXd product = scene.product(direction, {1.0, 0.0}, Curvature::exact);
  CHECK((product_from_forces(scene, direction, 1e-3) - product).norm() < 1e-9 * product.norm());
  CHECK(direction.dot(product) > 0.0);
}

TEST_CASE("Laplacian bending has no force on a straight line, however it lies, and no sum or moment") {
  ForcesOfScene flat(bending_grid(9, 6));
  CHECK(flat.forces_at_time(0.0).norm() < 1e-14);
  flat.shake(0.05, 0.0, 3);
  const Eigen::VectorXd force = flat.forces_at_time(0.0);
  const auto [sum, moment] = force_and_moment(flat.positions(), force);
  CHECK(sum.norm() < 1e-13 * force.norm());
  CHECK(moment.norm() < 1e-13 * force.norm());
}

TEST_CASE("Laplacian bending: every method bends a line back, and the bound holds") {
  Scene scene;
  add(scene, Rope{.particles = 12, .stretch = 100.0});
  LaplacianBending bending;
  for (Index i = 0; i + 2 < 12; ++i) {
    bending.first.push_back(i);
    bending.middle.push_back(i + 1);
    bending.last.push_back(i + 2);
    bending.stiffness.push_back(50.0);
  }
  scene.effects = {bending, Drag{0.05}};
  for (std::size_t i = 0; i < 12; ++i) scene.particles.position[i].y() += i % 2 == 0 ? 0.01 : -0.01;
  for (const Method& method : all_methods) {
    CAPTURE(to_string(method));
    const double limit = std::visit([](const auto& one) { return one.oscillation_limit; }, method);
    if (limit == 0.0) continue;  // lets undamped oscillations grow
    Simulation<double> simulation(scene, {.method = method, .step = 2e-3});
    const double before = simulation.energy().external;
    for (int i = 0; i < 100; ++i) REQUIRE(simulation.step(5).ok());
    CHECK(simulation.energy().external < 0.2 * before);
  }
}
