#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

#include <hooke/hooke.h>

#include "effects/effect_functions.h"
#include "effects/forces_of_scene.h"
#include "instruction_sets.h"
#include "irregular_mesh.h"
#include "model/hinges.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// Hinges alone, without springs.
Scene hinged_mesh(const HingeBending& bending) {
  Scene scene;
  ClothMesh mesh = irregular_mesh(7);
  mesh.stretch = mesh.bend = 0.0;
  add(scene, mesh);
  scene.effects = {bending};
  return scene;
}

Scene hinged_grid(const HingeBending& bending, Index columns = 20, Index rows = 5) {
  Scene scene;
  add(scene,
      ClothGrid{.columns = columns, .rows = rows, .spacing = 0.1, .stretch = 0.0, .shear = 0.0, .bend = 0.0});
  scene.effects = {bending};
  return scene;
}

/// Folds what lies beyond x = `fold` [m] up about the line there.
void fold_up(ForcesOfScene& scene, double fold, double angle) {
  Eigen::VectorXd x = scene.positions();
  for (Eigen::Index i = 0; i < x.size(); i += 3) {
    const double beyond = x[i] - fold;
    if (beyond <= 0.0) continue;
    x[i] = fold + std::cos(angle) * beyond;
    x[i + 2] += std::sin(angle) * beyond;
  }
  scene.set_positions(x);
}

void check_derivatives(ForcesOfScene& scene) {
  const Eigen::VectorXd force = scene.forces_at_time(0.0);
  REQUIRE(force.norm() > 0.0);
  CHECK((forces_from_energy(scene, 1e-6) - force).norm() < 1e-7 * force.norm());

  const Eigen::VectorXd direction = random_direction(scene.state().size(), 2);
  const Eigen::VectorXd product = scene.product(direction, {1.0, 0.0}, Curvature::exact);
  CHECK((product_from_forces(scene, direction, 1e-6) - product).norm() < 1e-6 * product.norm());
  CHECK(direction.dot(scene.product(direction, {1.0, 0.0}, Curvature::convex)) > 0.0);

  const auto [sum, moment] = force_and_moment(scene.positions(), force);
  CHECK(sum.norm() < 1e-12 * force.norm());
  CHECK(moment.norm() < 1e-12 * force.norm());
}

Eigen::MatrixXd stiffness_matrix(ForcesOfScene& scene, Curvature curvature) {
  const Eigen::Index size = scene.positions().size();
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i)
    matrix.col(i) = scene.product(Eigen::VectorXd::Unit(size, i), {1.0, 0.0}, curvature);
  return matrix;
}

/// A strip that is stretched by springs and pulled back to flat by its hinges.
Scene bent_strip(double stiffness) {
  Scene scene;
  const GridParticles grid =
      add(scene,
          ClothGrid{.columns = 10, .rows = 3, .spacing = 0.1, .stretch = 50.0, .shear = 20.0, .bend = 0.0});
  for (Index c = 5; c < grid.columns; ++c) {
    for (Index r = 0; r < grid.rows; ++r) {
      Vec3& x = scene.particles.position[grid.at(c, r)];
      const double beyond = x.x() - 0.4;
      x = Vec3(0.4 + std::cos(0.7) * beyond, x.y(), std::sin(0.7) * beyond);
    }
  }
  scene.effects = {HingeBending{.stiffness = stiffness}, Drag{0.004}};
  return scene;
}

}  // namespace

TEST_CASE("Hinge bending: energy, force and derivative agree, on a mesh and a grid, flat and folded") {
  SUBCASE("irregular mesh") {
    on_each_instruction_set([] {
      ForcesOfScene scene(hinged_mesh({.stiffness = 0.3}));
      scene.shake(0.02, 0.0, 1);
      check_derivatives(scene);
    });
  }
  SUBCASE("irregular mesh that rests as it lies") {
    ForcesOfScene scene(hinged_mesh({.stiffness = 0.3, .flat_at_rest = false}));
    CHECK(scene.forces_at_time(0.0).norm() < 1e-12);
    scene.shake(0.02, 0.0, 1);
    check_derivatives(scene);
  }
  SUBCASE("nearly flat grid") {
    ForcesOfScene scene(hinged_grid({.stiffness = 0.3}));
    CHECK(scene.forces_at_time(0.0).norm() == 0.0);
    scene.shake(0.005, 0.0, 3);
    check_derivatives(scene);
  }
  SUBCASE("grid folded by 120 degrees") {
    ForcesOfScene scene(hinged_grid({.stiffness = 0.3}));
    fold_up(scene, 0.95, 120.0 * degree);
    scene.shake(0.02, 0.0, 4);
    check_derivatives(scene);
  }
}

TEST_CASE("Hinge bending: the angle is right all the way round, in float too") {
  Scene scene;
  for (const Vec3& x : {Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0.5, 0), Vec3(1, 0.5, 0)})
    scene.add_particle(1.0, x);
  scene.triangles = {{0, 1, 2}, {1, 0, 3}};
  scene.effects = {HingeBending{.stiffness = 1.0}};
  const double k = hinges_of(scene, scene.triangles).at(0).stretch;
  CHECK(k == doctest::Approx(1.0));
  for (int i = -179; i < 180; ++i) {
    const double angle = i * degree;
    CAPTURE(i);
    scene.particles.position[3] = Vec3(std::cos(angle), 0.5, std::sin(angle));
    CHECK(Simulation<double>(scene).energy().external ==
          doctest::Approx(0.5 * k * angle * angle).epsilon(1e-12));
    ForcesOfScene forces(scene);
    // The wing is 1 m long: its force is the moment.
    const Eigen::VectorXd force = forces.forces_at_time(0.0);
    const Vec3 of_wing = force.segment<3>(Eigen::Index(3 * forces.model().order.engine(3)));
    CHECK(of_wing.norm() == doctest::Approx(k * std::abs(angle)).epsilon(1e-14));
    CHECK(of_wing.dot(scene.particles.position[3] - Vec3(0, 0.5, 0)) == doctest::Approx(0.0));
    Simulation<float> single(scene, {.step = 1e-3});
    REQUIRE(single.step(1).ok());
    const std::vector<float> v = single.snapshot().velocities;
    CHECK(std::hypot(v[9], v[10], v[11]) == doctest::Approx(1e-3 * k * std::abs(angle)).epsilon(1e-6));
  }
}

TEST_CASE("Hinge bending: rigid motion changes no force") {
  ForcesOfScene scene(hinged_mesh({.stiffness = 0.3, .damping = 0.1}));
  scene.shake(0.02, 0.0, 5);
  const Eigen::VectorXd x = scene.positions(), before = scene.forces_at_time(0.0);
  const Eigen::Matrix3d turn(Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()));
  const Vec3 shift(3.0, -2.0, 1.0), spin(0.5, 2.0, -1.0);
  Eigen::VectorXd moved = x, velocity = x, expected = before;
  for (Eigen::Index i = 0; i < x.size(); i += 3) {
    moved.segment<3>(i) = turn * x.segment<3>(i) + shift;
    velocity.segment<3>(i) = spin.cross(Vec3(moved.segment<3>(i))) + shift;
    expected.segment<3>(i) = turn * before.segment<3>(i);
  }
  scene.set_positions(moved);
  scene.set_velocities(velocity);
  CHECK((scene.forces_at_time(0.0) - expected).norm() < 1e-11 * before.norm());
}

TEST_CASE("Hinge bending: damping brakes the rate of the angle, and its derivative is known") {
  ForcesOfScene scene(hinged_mesh({.stiffness = 0.3, .damping = 0.05}));
  scene.shake(0.02, 0.0, 6);
  const Eigen::VectorXd still = scene.forces_at_time(0.0);
  const Eigen::VectorXd velocity = random_direction(scene.state().size(), 7);
  scene.set_velocities(velocity);
  const Eigen::VectorXd brake = scene.forces_at_time(0.0) - still;
  CHECK(brake.dot(velocity) < 0.0);
  const Eigen::VectorXd product = scene.product(velocity, {0.0, 1.0}, Curvature::convex);
  CHECK((product + brake).norm() < 1e-10 * brake.norm());
  const auto [sum, moment] = force_and_moment(scene.positions(), brake);
  CHECK(sum.norm() < 1e-12 * brake.norm());
  CHECK(moment.norm() < 1e-12 * brake.norm());
}

TEST_CASE("Hinge bending: a triangle without area has no force and spoils none") {
  ForcesOfScene scene(hinged_grid({.stiffness = 0.3, .damping = 0.1}, 4, 3));
  scene.shake(0.01, 1.0, 8);
  Eigen::VectorXd x = scene.positions();
  const auto corner = [&](Index user) { return Eigen::Index(3 * scene.model().order.engine(user)); };
  SUBCASE("two corners coincide") {
    x.segment<3>(corner(5)) = x.segment<3>(corner(6));
  }
  SUBCASE("corners in one line") {
    x.segment<3>(corner(5)) = 0.5 * (x.segment<3>(corner(1)) + x.segment<3>(corner(4)));
  }
  SUBCASE("all at one place") {
    x.setZero();
  }
  scene.set_positions(x);
  const Eigen::VectorXd force = scene.forces_at_time(0.0);
  CHECK(force.allFinite());
  CHECK(scene.product(x, {1.0, 1.0}, Curvature::exact).allFinite());
  CHECK(std::isfinite(scene.effect_energy()));
  CHECK(force_and_moment(x, force).first.norm() <= 1e-9 * force.norm());
}

TEST_CASE("Hinge bending: three triangles at an edge are three hinges; those without area none") {
  Scene scene;
  for (const Vec3& x : {Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(-1, 0, 0.2), Vec3(-1, 0, -0.2)})
    scene.add_particle(1.0, x);
  scene.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  CHECK(hinges_of(scene, scene.triangles).size() == 3);
  scene.particles.position[3] = scene.particles.position[4] = Vec3(0, 2, 0);
  CHECK(hinges_of(scene, scene.triangles).size() == 2);
}

TEST_CASE("Hinge bending: the bound on its stiffness holds for shapes folded to a right angle") {
  const HingeBending bending{.stiffness = 0.3};
  const Scene description = hinged_grid(bending, 6, 4);
  HeldParticles held(description.particles.size());
  add_bounds(bending, description, held);
  for (const double degrees : {0.0, 45.0, 90.0}) {
    CAPTURE(degrees);
    ForcesOfScene scene(description);
    fold_up(scene, 0.2, degrees * degree);
    Eigen::MatrixXd left = -stiffness_matrix(scene, Curvature::exact);
    for (Index user = 0; user < description.particles.size(); ++user) {
      const auto i = Eigen::Index(3 * scene.model().order.engine(user));
      left.diagonal().segment<3>(i).array() += held.stiffness(user);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(left);
    CHECK(solver.eigenvalues().minCoeff() > 0.0);
  }
}

TEST_CASE("Hinge bending: the matrix for solvers is symmetric and has no negative eigenvalue") {
  ForcesOfScene scene(hinged_mesh({.stiffness = 0.3}));
  scene.shake(0.02, 0.0, 9);
  for (const Curvature curvature : {Curvature::exact, Curvature::convex}) {
    const Eigen::MatrixXd matrix = stiffness_matrix(scene, curvature);
    CHECK((matrix - matrix.transpose()).norm() < 1e-11 * matrix.norm());
    if (curvature == Curvature::exact) continue;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
    CHECK(solver.eigenvalues().minCoeff() > -1e-10 * solver.eigenvalues().maxCoeff());
  }
}

TEST_CASE("Hinge bending: the same bits on any number of threads, and without stiffness as if not named") {
  const auto final_state = [](const Scene& scene, const Method& method, unsigned threads) {
    Simulation<double> simulation(scene, {.method = method, .step = 1e-3, .threads = threads});
    REQUIRE(simulation.step(8).ok());
    return simulation.state_hash();
  };
  Scene scene;
  add(scene, irregular_mesh(24));
  scene.effects = {HingeBending{.stiffness = 1e-4, .damping = 1e-3}};
  Scene zero = scene, none = scene;
  zero.effects = {HingeBending{.damping = 1e-3}};
  none.effects.clear();
  for (const Method& method : {Method{SymplecticEuler{}}, Method{BackwardEuler{}}}) {
    CAPTURE(to_string(method));
    CHECK(final_state(scene, method, 1) == final_state(scene, method, 3));
    CHECK(final_state(zero, method, 1) == final_state(none, method, 1));
    CHECK(final_state(scene, method, 1) != final_state(none, method, 1));
  }
}

TEST_CASE("Hinge bending: every method bends a strip back") {
  const Scene scene = bent_strip(0.02);
  for (const Method& method : all_methods) {
    CAPTURE(to_string(method));
    const double limit = std::visit([](const auto& one) { return one.oscillation_limit; }, method);
    if (limit == 0.0) continue;  // lets undamped oscillations grow
    Simulation<double> simulation(scene, {.method = method, .step = 2e-3});
    const double before = simulation.energy().external;
    for (int i = 0; i < 40; ++i) REQUIRE(simulation.step(5).ok());
    CHECK(simulation.energy().external < 0.2 * before);
  }
}

TEST_CASE("Hinge bending: methods that solve equations converge with steps of a frame") {
  for (const double stiffness : {0.02, 0.2}) {
    for (const Method& method :
         {Method{BackwardEuler{}}, Method{ImplicitMidpoint{}}, Method{Bdf2{}},
          Method{ProjectiveDynamics{.iterations = 1000, .tolerance = 1e-5, .history = 20}}}) {
      CAPTURE(stiffness);
      CAPTURE(to_string(method));
      Simulation<double> simulation(bent_strip(stiffness), {.method = method, .step = 1.0 / 60.0});
      for (int i = 0; i < 60; ++i) CHECK((simulation.step(1).flags & flag_not_converged) == 0);
    }
  }
}

TEST_CASE("Hinge bending: where triangles are named, only the edges between these bend") {
  const Scene all = hinged_grid({.stiffness = 0.3}, 6, 4);
  Scene part = all;
  std::vector<Index> first_row;
  for (Index t = 0; t < 10; ++t) first_row.push_back(t);
  part.effects = {HingeBending{.stiffness = 0.3, .triangles = first_row}};
  ForcesOfScene whole(all), some(part);
  whole.shake(0.01, 0.0, 3);
  some.shake(0.01, 0.0, 3);
  const Eigen::VectorXd of_all = whole.forces_at_time(0.0), of_some = some.forces_at_time(0.0);
  const auto at = [&](const ForcesOfScene& scene, const Eigen::VectorXd& forces, Index user) -> Vec3 {
    return forces.segment<3>(Eigen::Index(3 * scene.model().order.engine(user)));
  };
  for (Index column = 0; column < 6; ++column) {
    CHECK(at(some, of_some, column).norm() > 0.0);
    for (Index row = 2; row < 4; ++row) CHECK(at(some, of_some, 6 * row + column).isZero());
    CHECK(at(whole, of_all, 18 + column).norm() > 0.0);
  }

  part.effects = {HingeBending{.stiffness = 0.3, .triangles = {0, 99}}};
  CHECK_THROWS_WITH_AS(Simulation<double>{part},
                       doctest::Contains("hinge_bending): triangles[1] is 99, but the number of triangles is 30"),
                       SceneError);
}

TEST_CASE("Hinge bending without triangles is a fault that says what to do") {
  Scene scene;
  add(scene, Rope{});
  scene.effects = {HingeBending{.stiffness = 1.0}};
  CHECK_THROWS_WITH_AS(Simulation<double>{scene}, doctest::Contains("no triangles"), SceneError);
}
