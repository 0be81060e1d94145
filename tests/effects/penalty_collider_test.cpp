// What a collider with a stiffness does to a particle.

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Eigenvalues>

#include <hooke/hooke.h>

#include "effects/forces_of_scene.h"
#include "effects/penalty_scenes.h"
#include "effects/solid_meshes.h"
#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

HeightfieldShape flat_field(double height) {
  return {.columns = 5,
          .rows = 4,
          .spacing = 0.3,
          .heights = std::vector<double>(20, height),
          .corner = {-0.55, 0.0, -0.45}};
}

MeshShape box_mesh_at(const Vec3& centre, const Vec3& half) {
  MeshShape mesh = box_mesh(half);
  for (Vec3& vertex : mesh.vertices) vertex += centre;
  return mesh;
}

/// Solids whose tops are the origin.
const std::vector<ColliderShape>& shapes_below() {
  static const std::vector<ColliderShape> all{PlaneShape{},
                                              SphereShape{{0.0, -0.5, 0.0}, 0.5},
                                              CapsuleShape{{-0.3, -0.2, 0.0}, {0.4, -0.2, 0.0}, 0.2},
                                              BoxShape{{0.0, -0.4, 0.0}, {0.5, 0.4, 0.6}},
                                              flat_field(0.0),
                                              box_mesh_at({0.0, -0.4, 0.0}, {0.5, 0.4, 0.6})};
  return all;
}

/// Of one particle and a collider, at a time [s].
Vec3 force_at(ForcesOfScene& forces, const Vec3& place, const Vec3& velocity, double time = 0.0) {
  forces.set_positions(place);
  forces.set_velocities(velocity);
  return forces.forces_at_time(time);
}

Eigen::Matrix3d derivative_at(ForcesOfScene& forces, const Vec3& place, const Vec3& velocity,
                              const DerivativeWeights<double>& weights) {
  forces.set_positions(place);
  forces.set_velocities(velocity);
  StripBlocks<double> blocks{};
  forces.forces().effects().add_uncoupled_derivatives(Strip<double>(forces.state(), 0, 1), 0.0, weights,
                                                      blocks);
  return Eigen::Matrix3d{{blocks.xx[0], blocks.xy[0], blocks.xz[0]},
                         {blocks.xy[0], blocks.yy[0], blocks.yz[0]},
                         {blocks.xz[0], blocks.yz[0], blocks.zz[0]}};
}

}  // namespace

TEST_CASE("penalty: on each shape a particle comes to rest m g / k below its thickness") {
  constexpr double k = 2000.0, thickness = 0.02, depth = mass * g / k;
  for (const ColliderShape& shape : shapes_below()) {
    CAPTURE(shape.index());
    const Collider collider{.shape = shape, .thickness = thickness, .stiffness = k, .damping = 40.0};
    Simulation<double> simulation(one_over(collider, {0.0, thickness, 0.0}), {.step = 1e-3});
    REQUIRE(simulation.step(2000).ok());
    CHECK(position(simulation, 0).y() == doctest::Approx(thickness - depth).epsilon(1e-9));
    CHECK(velocity(simulation, 0).norm() < 1e-9);
    CHECK(simulation.energy().external ==
          doctest::Approx(0.5 * k * depth * depth + mass * g * (thickness - depth)).epsilon(1e-6));
  }
}

TEST_CASE("penalty: what hits it is in it for half a period and leaves with the restitution of its damping") {
  constexpr double k = 3000.0, speed = 2.0;
  for (const double z : {0.0, 0.1, 0.5}) {
    CAPTURE(z);
    const double c = 2.0 * z * std::sqrt(k * mass);
    Scene scene = one_over({.stiffness = k, .damping = c}, {0.0, 1e-9, 0.0}, {0.0, -speed, 0.0});
    scene.effects.erase(scene.effects.begin());
    Simulation<double> simulation(scene, {.method = RungeKutta4{}, .step = 1e-5});
    // Until spring and damper would pull: for z = 0 half a period, and the same speed as before.
    const double w = std::sqrt(k / mass), root = std::sqrt(1.0 - z * z);
    const double time = std::acos(2.0 * z * z - 1.0) / (w * root);
    const double left = std::exp(-z / root * std::acos(2.0 * z * z - 1.0));
    REQUIRE(simulation.step(std::uint64_t(0.98 * time / 1e-5)).ok());
    CHECK(velocity(simulation, 0).y() < left * speed);
    REQUIRE(simulation.step(std::uint64_t(0.04 * time / 1e-5)).ok());
    CHECK(velocity(simulation, 0).y() == doctest::Approx(left * speed).epsilon(1e-3));
  }
}

TEST_CASE("penalty: the force is the formula's, against a solid that moves and turns") {
  const Collider box{.shape = BoxShape{{0.1, -0.4, 0.2}, {0.5, 0.4, 0.6}},
                     .thickness = 0.01,
                     .friction = 0.4,
                     .stiffness = 700.0,
                     .damping = 5.0,
                     .axis = {0.3, 1.0, -0.2},
                     .path = {{0.0, {0, 0, 0}, 0.0}, {2.0, {0.3, -0.1, 0.2}, 200.0}}};
  Scene scene;
  scene.add_particle(mass, Vec3::Zero());
  scene.effects = {box};
  ForcesOfScene forces(scene);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int sliding = 0, held = 0, pulled = 0;
  for (int i = 0; i < 200; ++i) {
    const double time = 1.0 + unit(random) * 0.9, part = time / 2.0;
    const Vec3 axis = box.axis.normalized(), origin = Vec3(0.1, -0.4, 0.2) + part * box.path[1].displacement;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(part * 200.0 * M_PI / 180.0, axis).toRotationMatrix();
    const double depth = 0.02 * (1.0 + unit(random));
    const Vec3 local(0.4 * unit(random), 0.41 - depth, 0.5 * unit(random)), place = origin + turn * local;
    const Vec3 spin = 100.0 * M_PI / 180.0 * axis, n = turn.col(1);
    const Vec3 of_solid = 0.5 * box.path[1].displacement + spin.cross(place - origin);
    const Vec3 v(2.0 * unit(random), 2.0 * unit(random), 2.0 * unit(random)), against = v - of_solid;
    const double u = n.dot(against), normal = 700.0 * depth - 5.0 * u;
    const Vec3 w = against - u * n;
    Vec3 expected = Vec3::Zero();
    if (normal > 0.0) expected = normal * n - std::min(5.0 * w.norm(), 0.4 * normal) * w.normalized();
    const Vec3 found = force_at(forces, place, v, time);
    CHECK((found - expected).norm() < 1e-9 * (1.0 + expected.norm()));
    pulled += normal <= 0.0 ? 1 : 0;
    held += normal > 0.0 && 5.0 * w.norm() < 0.4 * normal ? 1 : 0;
    sliding += normal > 0.0 && 5.0 * w.norm() > 0.4 * normal ? 1 : 0;
  }
  CHECK(std::min({sliding, held, pulled}) > 10);
}

TEST_CASE("penalty: forces are the energy's gradient, on meshes too, and deep inside") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<ColliderShape> shapes = shapes_below();
  shapes.push_back(bumpy_mesh(2));
  for (const ColliderShape& shape : shapes) {
    CAPTURE(shape.index());
    Scene scene;
    for (int i = 0; i < 150; ++i) {
      const double x = unit(random), y = unit(random), z = unit(random);
      scene.add_particle(1.0, 0.6 * Vec3(x, y, z));
    }
    scene.effects = {Collider{.shape = shape, .thickness = 0.03, .stiffness = 50.0}};
    ForcesOfScene forces(scene);
    const Eigen::VectorXd expected = forces_from_energy(forces, 1e-7);
    const Eigen::VectorXd found = forces.forces_at_time(0.0);
    CHECK(found.norm() > 5.0);
    CHECK((found - expected).norm() < 1e-5 * found.norm());
  }
}

TEST_CASE("penalty: its depth in a mesh is the distance to its nearest triangle, however deep") {
  const MeshShape mesh = angle_mesh();
  Scene scene;
  std::mt19937 random(6);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 400; ++i) {
    const double x = unit(random), y = unit(random), z = unit(random);
    scene.add_particle(1.0, {x, y, z - 0.4});
  }
  scene.effects = {Collider{.shape = mesh, .stiffness = 1.0}};
  ForcesOfScene forces(scene);
  const Eigen::VectorXd found = forces.forces_at_time(0.0);
  int inside = 0;
  for (Index i = 0; i < 400; ++i) {
    const double depth = std::max(0.0, -distance_to_mesh(mesh, scene.particles.position[i]));
    const Index place = forces.model().order.engine(i);
    CHECK(found.segment<3>(Eigen::Index(3 * place)).norm() == doctest::Approx(depth).epsilon(1e-9));
    inside += depth > 0.0 ? 1 : 0;
  }
  CHECK(inside > 100);
}

TEST_CASE("penalty: the derivative meets central differences where it holds, and never has negative ones") {
  const double angle = 0.4;
  const Collider plane = incline(angle, 0.4);
  Scene scene;
  scene.add_particle(mass, Vec3::Zero());
  scene.effects = {plane};
  ForcesOfScene forces(scene);
  const Vec3 n = std::get<PlaneShape>(plane.shape).normal, place = -0.01 * n;
  const auto by_differences = [&](const Vec3& v) {
    Eigen::Matrix3d stiffness, damping;
    for (int k = 0; k < 3; ++k) {
      const double h = 1e-7;
      const Vec3 step = h * Vec3::Unit(k);
      stiffness.col(k) = -(force_at(forces, place + step, v) - force_at(forces, place - step, v)) / (2.0 * h);
      damping.col(k) = -(force_at(forces, place, v + step) - force_at(forces, place, v - step)) / (2.0 * h);
    }
    return std::pair(stiffness, damping);
  };
  // What friction holds: all of it is symmetric.
  const Vec3 slow(1e-3, 2e-3, -1e-3);
  const auto [stiffness, damping] = by_differences(slow);
  CHECK((derivative_at(forces, place, slow, {1.0, 0.0}) - stiffness).norm() < 1e-6 * stiffness.norm());
  CHECK((derivative_at(forces, place, slow, {0.0, 1.0}) - damping).norm() < 1e-6 * damping.norm());
  // What slides: along the normal, and across the way.
  const Vec3 fast = 3.0 * Vec3(std::cos(angle), std::sin(angle), 0.0), across = Vec3::UnitZ();
  const auto [k, c] = by_differences(fast);
  const Eigen::Matrix3d found_k = derivative_at(forces, place, fast, {1.0, 0.0}),
                        found_c = derivative_at(forces, place, fast, {0.0, 1.0});
  CHECK(n.dot(found_k * n) == doctest::Approx(n.dot(k * n)).epsilon(1e-6));
  CHECK(n.dot(found_c * n) == doctest::Approx(n.dot(c * n)).epsilon(1e-6));
  CHECK(across.dot(found_c * across) == doctest::Approx(across.dot(c * across)).epsilon(1e-6));
  const Eigen::Vector3d values = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(found_c).eigenvalues();
  CHECK(values.minCoeff() > 0.0);
  CHECK(values.maxCoeff() <= plane.damping * (1.0 + 1e-12));
  // Above it, and where it would be pulled, there is none.
  CHECK(derivative_at(forces, 0.01 * n, fast, {1.0, 1.0}).isZero(0.0));
  CHECK(derivative_at(forces, place, 1e3 * n, {1.0, 1.0}).isZero(0.0));
}

TEST_CASE("penalty: without friction nothing brakes along it, at rest neither") {
  Scene scene;
  scene.add_particle(mass, Vec3::Zero());
  scene.effects = {Collider{.stiffness = 1e5, .damping = 200.0}};
  ForcesOfScene forces(scene);
  const Vec3 n = Vec3::UnitY();
  const Eigen::Matrix3d expected = 200.0 * n * n.transpose();
  for (const double slip : {0.0, 1e-30, 1.0}) {
    CAPTURE(slip);
    CHECK((derivative_at(forces, -0.01 * n, {slip, 0.0, 0.0}, {0.0, 1.0}) - expected).norm() < 1e-9);
  }
}

TEST_CASE("penalty: each fault of its values is named") {
  Scene scene = one_particle();
  scene.effects = {Collider{.stiffness = -1.0, .damping = NAN}, Collider{.stiffness = INFINITY},
                   Collider{.restitution = 0.5, .stiffness = 10.0}, Collider{.damping = 2.0}};
  std::string all;
  for (const Fault& fault : validate(scene)) all += fault.message() + "\n";
  CAPTURE(all);
  for (const char* expected :
       {"stiffness is -1 N/m; give a finite value >= 0", "damping is nan N s/m; give a finite value >= 0",
        "stiffness is inf N/m", "restitution is 0.5 beside a stiffness; give 0",
        "damping is 2 N s/m without a stiffness; give a stiffness > 0"})
    CHECK(all.find(expected) != all.npos);
}
