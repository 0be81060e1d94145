#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include <hooke/hooke.h>

#include "effects/forces_of_scene.h"
#include "irregular_mesh.h"
#include "scenes.h"
#include "stability/held_particles.h"

#include "effects/effect_functions.h"

using namespace hooke;
using namespace hooke::test;

namespace {

TensileTriangles sheet_of(double nu, double damping = 0.0) {
  return {.modulus = 50.0, .poisson_ratio = nu, .damping = damping};
}

/// A mesh of n x n particles a metre wide without springs.
Scene sheet(Index n, const TensileTriangles& effect, std::uint32_t seed = 1) {
  ClothMesh mesh = irregular_mesh(n, seed);
  mesh.stretch = mesh.bend = 0.0;
  Scene scene;
  add(scene, mesh);
  scene.effects = {effect};
  return scene;
}

/// A triangle's corners in the plane in which it lies, or its sides in space: two columns.
using Sides = Eigen::Matrix<double, 3, 2>;

Sides sides_of(const std::vector<Vec3>& x, const Triangle& t) {
  Sides sides;
  sides << x[t[1]] - x[t[0]], x[t[2]] - x[t[0]];
  return sides;
}

/// Energy of constant strain triangles of the material of St. Venant and Kirchhoff, in plane stress: with
/// F = D R^-1, R the sides at rest in their plane, E = (F^T F - 1) / 2,
/// W = A (G tr E^2 + lambda / 2 (tr E)^2), G = Y / (2 (1 + nu)), lambda = Y nu / (1 - nu^2).
double finite_element_energy(const Scene& scene, const std::vector<Vec3>& now, const TensileTriangles& law) {
  const double nu = law.poisson_ratio, shear = law.modulus / (2.0 * (1.0 + nu)),
               lambda = law.modulus * nu / (1.0 - nu * nu);
  double sum = 0.0;
  for (const Triangle& triangle : scene.triangles) {
    const Sides rest = sides_of(scene.particles.position, triangle);
    const Vec3 u = rest.col(0).normalized();
    const Vec3 v = (rest.col(1) - u * u.dot(rest.col(1))).normalized();
    const Eigen::Matrix2d flat{{u.dot(rest.col(0)), u.dot(rest.col(1))},
                               {v.dot(rest.col(0)), v.dot(rest.col(1))}};
    const Sides gradient = sides_of(now, triangle) * flat.inverse();
    const Eigen::Matrix2d strain = 0.5 * (gradient.transpose() * gradient - Eigen::Matrix2d::Identity());
    const double trace = strain.trace();
    sum += 0.5 * flat.determinant() * (shear * (strain * strain).trace() + 0.5 * lambda * trace * trace);
  }
  return sum;
}

std::vector<Vec3> in_users_order(const ForcesOfScene& scene) {
  std::vector<Vec3> positions;
  const Eigen::VectorXd x = scene.positions();
  for (Index i = 0; i < x.size() / 3; ++i)
    positions.emplace_back(x.segment<3>(3 * Eigen::Index(scene.model().order.engine(i))));
  return positions;
}

}  // namespace

TEST_CASE("tensile triangles: the energy is that of finite elements of St. Venant and Kirchhoff") {
  for (const double nu : {-0.9, 0.0, 0.3, 1.0 / 3.0, 0.9}) {
    CAPTURE(nu);
    const Scene scene = sheet(9, sheet_of(nu));
    ForcesOfScene forces(scene);
    forces.shake(0.03, 0.0, 1);
    const double expected = finite_element_energy(scene, in_users_order(forces), sheet_of(nu));
    CHECK(std::abs(forces.effect_energy() - expected) < 1e-13 * expected);
  }
}

TEST_CASE("tensile triangles: energy, force and derivative agree") {
  for (const double nu : {-0.5, 0.0, 0.3, 0.8}) {
    CAPTURE(nu);
    ForcesOfScene scene(sheet(7, sheet_of(nu)));
    scene.shake(0.02, 0.0, 2);
    const Eigen::VectorXd force = scene.forces_at_time(0.0);
    CHECK((forces_from_energy(scene, 1e-5) - force).norm() < 1e-7 * force.norm());
    const Eigen::VectorXd direction = random_direction(scene.state().size(), 3);
    const Eigen::VectorXd product = scene.product(direction, {1.0, 0.0}, Curvature::exact);
    CHECK((product_from_forces(scene, direction, 1e-6) - product).norm() < 1e-7 * product.norm());
  }
}

TEST_CASE("tensile triangles: the damping is the derivative by velocities, and takes energy alone") {
  ForcesOfScene scene(sheet(7, sheet_of(0.3, 0.02)));
  scene.shake(0.02, 0.0, 4);
  const Eigen::VectorXd still = scene.forces_at_time(0.0);
  const Eigen::VectorXd velocity = random_direction(scene.state().size(), 5);
  scene.set_velocities(velocity);
  const Eigen::VectorXd damping = scene.forces_at_time(0.0) - still;
  CHECK(damping.dot(velocity) < -0.1);
  const Eigen::VectorXd product = scene.product(velocity, {0.0, 1.0}, Curvature::exact);
  CHECK((damping + product).norm() < 1e-12 * damping.norm());
  const auto [sum, moment] = force_and_moment(scene.positions(), damping);
  CHECK(sum.norm() < 1e-12 * damping.norm());
  CHECK(moment.norm() < 1e-12 * damping.norm());
}

TEST_CASE("tensile triangles: no force on what is only moved and turned, and no sum or moment of forces") {
  ForcesOfScene scene(sheet(9, sheet_of(0.3)));
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  Eigen::VectorXd moved = scene.positions();
  for (Eigen::Index i = 0; i < moved.size(); i += 3)
    moved.segment<3>(i) = (turn * moved.segment<3>(i) + Vec3(1, -2, 0.5)).eval();
  scene.set_positions(moved);
  CHECK(scene.forces_at_time(0.0).norm() < 1e-12);
  scene.shake(0.03, 0.0, 6);
  const Eigen::VectorXd force = scene.forces_at_time(0.0);
  const auto [sum, moment] = force_and_moment(scene.positions(), force);
  CHECK(sum.norm() < 1e-12 * force.norm());
  CHECK(moment.norm() < 1e-12 * force.norm());
}

TEST_CASE("tensile triangles: the convex derivative has no negative eigenvalues, and keeps to its bounds") {
  const Scene still = sheet(5, sheet_of(0.3));
  ForcesOfScene scene(still);
  const auto n = Eigen::Index(3 * scene.state().size());
  const auto matrix = [&](Curvature curvature) {
    Eigen::MatrixXd whole(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
      whole.col(i) = scene.product(Eigen::VectorXd::Unit(n, i), {1.0, 0.0}, curvature);
    return whole;
  };
  const auto least = [](const Eigen::MatrixXd& m) {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m).eigenvalues()[0];
  };

  HeldParticles held(still.particles.size());
  add_bounds(std::get<TensileTriangles>(still.effects[0]), still, held);
  Eigen::VectorXd bounds(n);
  for (Index i = 0; i < still.particles.size(); ++i)
    bounds.segment<3>(3 * Eigen::Index(scene.model().order.engine(i))).setConstant(held.stiffness(i));
  const Eigen::MatrixXd at_rest = matrix(Curvature::exact);
  CHECK(least(Eigen::MatrixXd(bounds.asDiagonal()) - 1.5 * at_rest) > -1e-9);
  const Eigen::VectorXd x = scene.positions();
  scene.set_positions(1.15 * x);
  CHECK(least(Eigen::MatrixXd(bounds.asDiagonal()) - matrix(Curvature::exact)) > -1e-9);

  scene.set_positions(0.8 * x);
  scene.shake(0.02, 0.0, 7);
  CHECK(least(matrix(Curvature::exact)) < -1.0);
  CHECK(least(matrix(Curvature::convex)) > -1e-9);
}

TEST_CASE(
    "tensile triangles: the same bits on any number of threads, and those of none where the modulus is 0") {
  const auto end_of = [](const Scene& scene, const Method& method, unsigned threads) {
    Simulation<double> simulation(scene, {.method = method, .step = 2e-4, .threads = threads});
    REQUIRE(simulation.step(20).ok());
    std::vector<Vec3> positions;
    for (Index i = 0; i < scene.particles.size(); ++i) positions.push_back(position(simulation, i));
    return positions;
  };
  for (const Method& method : std::vector<Method>{Verlet{}, BackwardEuler{}}) {
    Scene scene;
    add(scene, irregular_mesh(24));
    scene.pin(0);
    scene.effects = {Gravity{}};
    const auto without = end_of(scene, method, 1);
    scene.effects.push_back(TensileTriangles{.modulus = 0.0});
    CHECK(end_of(scene, method, 1) == without);
    scene.effects.back() = sheet_of(0.3, 1e-3);
    const auto with = end_of(scene, method, 1);
    CHECK(with != without);
    CHECK(end_of(scene, method, 3) == with);
  }
}

TEST_CASE("tensile triangles: every method brings a sheet that flies apart to rest") {
  Scene scene = sheet(6, sheet_of(0.3, 2e-3));
  scene.effects.push_back(Drag{0.02});
  for (const Vec3& x : scene.particles.position)
    scene.particles.velocity.push_back(2.0 * (x - Vec3(0.5, -0.5, 0.0)));
  for (const Method& method : all_methods) {
    CAPTURE(to_string(method));
    const double limit = std::visit([](const auto& one) { return one.oscillation_limit; }, method);
    if (limit == 0.0) continue;  // lets undamped oscillations grow
    Simulation<double> simulation(scene, {.method = method, .step = 1e-3});
    const double before = simulation.energy().kinetic;
    double most = 0.0;
    for (int i = 0; i < 60; ++i) {
      REQUIRE(simulation.step(5).ok());
      most = std::max(most, simulation.energy().external);
    }
    CHECK(most > 0.05 * before);
    CHECK(simulation.energy().external + simulation.energy().kinetic < 0.2 * before);
  }
}

TEST_CASE("tensile triangles: what cannot be is refused with a reason") {
  Scene scene = sheet(3, sheet_of(0.3));
  const auto fault = [&](const TensileTriangles& effect) {
    scene.effects = {effect};
    const std::vector<Fault> faults = validate(scene);
    REQUIRE(faults.size() == 1);
    return faults[0].message();
  };
  const auto has = [](const std::string& text, const char* part) { return text.find(part) != text.npos; };
  CHECK(has(fault({.modulus = -1.0}), "modulus is -1 N/m"));
  CHECK(has(fault({.modulus = NAN}), "modulus is nan N/m"));
  CHECK(has(fault({.poisson_ratio = 1.0}), "poisson_ratio is 1; give a value > -1 and < 1"));
  CHECK(has(fault({.poisson_ratio = NAN}), "poisson_ratio"));
  CHECK(has(fault({.damping = -1.0}), "damping is -1 s"));
  CHECK(has(fault({.triangles = {8}}), "a triangle"));
  scene.particles.position[scene.triangles[3][0]] = scene.particles.position[scene.triangles[3][1]];
  scene.effects = {sheet_of(0.3)};
  const std::vector<Fault> faults = validate(scene);
  REQUIRE(!faults.empty());
  CHECK(has(faults[0].message(), "has no area at the start"));
  CHECK(has(fault({.modulus = 1.0, .triangles = {3}}), "triangle 3 has no area"));
}
