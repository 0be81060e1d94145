#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <hooke/hooke.h>

#include "effects/forces_of_scene.h"
#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double mass = 0.1, radius = 0.05, stiffness = 1e4;  // [kg], [m], [N/m]

/// Two grains that fly at each other along a slanted line.
Scene two_grains(double damping) {
  Scene scene;
  const Vec3 along = Vec3(2.0, 1.0, -0.5).normalized();
  scene.add_particle(mass, -1.1 * radius * along, 0.5 * along);
  scene.add_particle(mass, 1.1 * radius * along, -0.5 * along);
  scene.effects = {ParticleContact{.radius = {radius}, .stiffness = stiffness, .damping = damping}};
  return scene;
}

/// A small ball lies on a pinned ball, where that is as steep as a slope of this angle [rad].
Scene grain_on_slope(double angle, double friction) {
  constexpr double pinned_radius = 50.0;
  const double weight = mass * 9.81, sunk = weight * std::cos(angle) / stiffness;
  const Vec3 normal(std::sin(angle), std::cos(angle), 0.0);
  Scene scene;
  scene.add_particle(1.0, -(pinned_radius + radius - sunk) * normal);
  scene.add_particle(mass, Vec3::Zero());
  scene.pin(0);
  const double damping = 2.0 * std::sqrt(stiffness * mass);
  scene.effects = {Gravity{{0.0, -9.81, 0.0}}, ParticleContact{.radius = {pinned_radius, radius},
                                                               .stiffness = stiffness,
                                                               .damping = damping,
                                                               .shear_stiffness = stiffness,
                                                               .shear_damping = damping,
                                                               .friction = friction}};
  return scene;
}

/// Grains of several sizes at random places, some of which overlap.
Scene cloud(std::size_t count, double width, unsigned seed) {
  Scene scene;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  ParticleContact contact{
      .stiffness = 2e3, .damping = 1.0, .shear_stiffness = 1e3, .shear_damping = 0.5, .friction = 0.4};
  const auto draw = [&] {
    const double x = unit(random), y = unit(random), z = unit(random);
    return Vec3(x, y, z);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 place = width * draw(), velocity = draw();
    scene.add_particle(0.05 + 0.1 * unit(random), place, velocity);
    contact.radius.push_back(0.02 + 0.02 * unit(random));
  }
  scene.effects = {contact};
  return scene;
}

/// A heap in a tray.
Scene heap() {
  Scene scene = cloud(150, 0.3, 5);
  scene.effects.emplace_back(Gravity{{0.0, -9.81, 0.0}});
  scene.effects.emplace_back(Drag{0.05});
  const Vec3 walls[] = {{0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const Vec3& normal : walls)
    scene.effects.emplace_back(Collider{
        .shape = PlaneShape{normal, normal.sum() < 0.0 ? -0.35 : -0.05}, .thickness = 0.03, .friction = 0.4});
  return scene;
}

/// The force on each particle, pair by pair, of a cloud whose grains have just met.
std::vector<Vec3> forces_by_all_pairs(const Scene& scene) {
  const auto& contact = std::get<ParticleContact>(scene.effects[0]);
  const Particles& grains = scene.particles;
  std::vector<Vec3> forces(grains.size(), Vec3::Zero());
  for (std::size_t i = 0; i < grains.size(); ++i) {
    for (std::size_t j = i + 1; j < grains.size(); ++j) {
      const Vec3 apart = grains.position[i] - grains.position[j], v = grains.velocity[i] - grains.velocity[j];
      const double depth = contact.radius[i] + contact.radius[j] - apart.norm();
      if (depth <= 0.0) continue;
      const Vec3 n = apart.normalized();
      const double push = contact.stiffness * depth - contact.damping * v.dot(n);
      Vec3 rub = contact.shear_damping * (v - v.dot(n) * n);
      const double most = contact.friction * std::max(push, 0.0);
      if (rub.norm() > most) rub *= most / rub.norm();
      forces[i] += push * n - rub;
      forces[j] -= push * n - rub;
    }
  }
  return forces;
}

}  // namespace

TEST_CASE("two grains part with the speed that the formula of a damped spring gives") {
  for (const double share : {0.0, 0.05, 0.2, 0.5}) {
    CAPTURE(share);
    const double half = 0.5 * mass, damping = share * 2.0 * std::sqrt(stiffness * half);
    const double time = std::numbers::pi / std::sqrt(stiffness / half * (1.0 - share * share));
    Simulation<double> simulation(two_grains(damping), {.step = time / 200.0});
    const Vec3 momentum = simulation.momentum();
    REQUIRE(simulation.step(std::uint64_t(200.0 * (1.0 + 0.3 * radius / time))).ok());
    const double apart = (velocity(simulation, 0) - velocity(simulation, 1)).norm();
    CHECK(
        apart ==
        doctest::Approx(std::exp(-std::numbers::pi * share / std::sqrt(1.0 - share * share))).epsilon(0.01));
    CHECK((simulation.momentum() - momentum).norm() < 1e-15);
  }
}

TEST_CASE("a grain on a slope holds below the angle of friction and slides above it") {
  const double friction = 0.5, limit = std::atan(friction);
  Simulation<double> holds(grain_on_slope(0.99 * limit, friction), {.step = 1e-4});
  REQUIRE(holds.step(5000).ok());
  const Vec3 before = position(holds, 1);
  REQUIRE(holds.step(5000).ok());
  CHECK((position(holds, 1) - before).norm() / 0.5 < 1e-4);

  const double angle = 1.2 * limit;
  Simulation<double> slides(grain_on_slope(angle, friction), {.step = 1e-4});
  REQUIRE(slides.step(2000).ok());
  const Vec3 v = velocity(slides, 1);
  REQUIRE(slides.step(2000).ok());
  const double a = (velocity(slides, 1) - v).norm() / 0.2;
  CHECK(a == doctest::Approx(9.81 * (std::sin(angle) - friction * std::cos(angle))).epsilon(0.02));
}

TEST_CASE("the pairs of the grid are all that touch") {
  for (unsigned seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    const Scene scene = cloud(60, 0.25, seed);
    ForcesOfScene forces(scene);
    const auto found = forces.forces_at_time(0.0);
    const std::vector<Vec3> expected = forces_by_all_pairs(scene);
    double worst = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const auto e = Eigen::Index(3 * forces.model().order.engine(Index(i)));
      worst = std::max(worst, (found.segment<3>(e) - expected[i]).norm());
    }
    CHECK(worst < 1e-10);
  }
}

TEST_CASE("what springs join do not push each other") {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  scene.add_particle(1.0, {0.125, 0.0, 0.0});
  scene.add_particle(1.0, {0.0, 5.0, 0.0});
  scene.add_spring(1, 0, 0.0, 0.125);
  scene.effects = {ParticleContact{.radius = {0.5}, .stiffness = 1e3}};
  Simulation<double> simulation(scene, {.step = 1e-3});
  REQUIRE(simulation.step(10).ok());
  CHECK(velocity(simulation, 0).norm() == 0.0);
}

TEST_CASE("grains at one place part, and keep momentum") {
  Scene scene;
  for (int i = 0; i < 3; ++i) scene.add_particle(1.0, Vec3::Zero());
  scene.effects = {ParticleContact{.radius = {0.1}, .stiffness = 100.0, .damping = 1.0}};
  Simulation<float> simulation(scene, {.step = 1e-3});
  REQUIRE(simulation.step(2000).ok());
  CHECK(simulation.momentum().norm() < 1e-5);
  CHECK((position(simulation, 0) - position(simulation, 1)).norm() > 0.19);
}

TEST_CASE("a heap of grains comes to rest and does not creep") {
  Simulation<double> simulation(heap(), {.step = 1e-3});
  REQUIRE(simulation.step(7000).ok());
  CHECK(simulation.energy().kinetic < 1e-9);
  const std::vector<double> before = simulation.snapshot().positions;
  REQUIRE(simulation.step(500).ok());
  const std::vector<double> after = simulation.snapshot().positions;
  double furthest = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i)
    furthest = std::max(furthest, std::abs(after[i] - before[i]));
  CHECK(furthest < 1e-5);  // half a second: 1 mm a minute is 8e-6
}

TEST_CASE("grains that hold each other do so where they are teleported to, and forget whom they leave") {
  const double friction = 0.5;
  Scene scene = grain_on_slope(0.9 * std::atan(friction), friction);
  std::get<Gravity>(scene.effects[0]).acceleration = Vec3::Zero();
  // Pushed along the slope it swings about where it touched first, as long as friction holds.
  scene.particles.velocity.assign(2, Vec3::Zero());
  scene.particles.velocity[1] = {0.0, 0.0, 1e-3};
  scene.particles.position[0] *= 1.0 - 1e-5;
  Simulation<double> stays(scene, {.step = 1e-4}), goes(scene, {.step = 1e-4});
  REQUIRE(stays.step(20).ok());
  REQUIRE(goes.step(20).ok());
  const RigidPose pose{{1.0, 2.0, 3.0},
                       Eigen::Quaterniond(Eigen::AngleAxisd(1.0, Vec3(1.0, 2.0, -1.0).normalized()))};
  goes.teleport(pose);
  REQUIRE(stays.step(20).ok());
  REQUIRE(goes.step(20).ok());
  CHECK((goes.snapshot().pairs[0].size()) == 1);
  CHECK((position(goes, 1) - (pose.rotation * position(stays, 1) + pose.displacement)).norm() < 1e-12);
  const Index one[] = {1};
  goes.teleport(one, RigidPose{{0.0, 1.0, 0.0}, Eigen::Quaterniond::Identity()});
  CHECK(goes.snapshot().pairs[0].empty());
}

TEST_CASE("a heap has the same bits on any number of threads, and goes on with them from a snapshot") {
  Simulation<float> one(heap(), {.step = 1e-3, .threads = 1}), three(heap(), {.step = 1e-3, .threads = 3});
  REQUIRE(one.step(150).ok());
  REQUIRE(three.step(150).ok());
  CHECK(one.state_hash() == three.state_hash());
  const Snapshot<float> snapshot = one.snapshot();
  REQUIRE(snapshot.pairs.size() == 1);
  CHECK(snapshot.pairs[0].size() > 20);
  Simulation<float> again(heap(), {.step = 1e-3});
  again.restore(snapshot);
  REQUIRE(one.step(50).ok());
  REQUIRE(again.step(50).ok());
  CHECK(one.state_hash() == again.state_hash());
}

TEST_CASE("a heap that is changed between steps goes on like one that begins there") {
  Simulation<double> steps(heap(), {.step = 1e-3});
  REQUIRE(steps.step(149).ok());
  const Snapshot<double> before = steps.snapshot();
  REQUIRE(steps.step().ok());
  const Snapshot<double> whole = steps.snapshot();
  Snapshot<double> forgets = whole, moves = whole, flies = whole;
  forgets.pairs[0].clear();
  moves.positions[3] += 1e-4;
  flies.velocities[4] += 1e-2;
  std::vector<std::uint64_t> hashes;
  for (const Snapshot<double>& changed : {whole, forgets, moves, flies}) {
    Simulation<double> begins(heap(), {.step = 1e-3});
    begins.restore(changed);
    steps.restore(before);
    REQUIRE(steps.step().ok());
    steps.restore(changed);
    REQUIRE(steps.step(10).ok());
    REQUIRE(begins.step(10).ok());
    CHECK(steps.state_hash() == begins.state_hash());
    CHECK(std::ranges::count(hashes, steps.state_hash()) == 0);
    hashes.push_back(steps.state_hash());
  }
}

TEST_CASE("a snapshot with pairs that cannot be is refused") {
  Simulation<float> simulation(heap(), {.step = 1e-3});
  REQUIRE(simulation.step(100).ok());
  const Snapshot<float> good = simulation.snapshot();
  REQUIRE(!good.pairs[0].empty());
  Snapshot<float> bad = good;
  bad.pairs.clear();
  CHECK_THROWS_AS(simulation.restore(bad), std::invalid_argument);
  bad = good;
  bad.pairs[0][0].second = 1000;
  CHECK_THROWS_AS(simulation.restore(bad), std::invalid_argument);
  bad = good;
  bad.pairs[0][0].value[1] = NAN;
  CHECK_THROWS_AS(simulation.restore(bad), std::invalid_argument);
  CHECK_NOTHROW(simulation.restore(good));
}

TEST_CASE("a column of grains stands as high as its weight lets it, by every family of methods") {
  Scene scene;
  for (int i = 0; i < 4; ++i) scene.add_particle(mass, {0.0, 2.0 * radius * i, 0.0});
  scene.pin(0);
  scene.effects = {Gravity{{0.0, -9.81, 0.0}}, Drag{1.0},
                   ParticleContact{.radius = {radius},
                                   .stiffness = stiffness,
                                   .damping = 5.0,
                                   .shear_stiffness = stiffness,
                                   .friction = 0.5}};
  const double weight = mass * 9.81;
  for (const Method& method :
       {Method(SymplecticEuler{}), Method(Verlet{}), Method(RungeKutta4{}), Method(BackwardEuler{}),
        Method(Bdf2{}), Method(VertexBlockDescent{}), Method(Xpbd{})}) {
    CAPTURE(to_string(method));
    Simulation<double> simulation(scene, {.method = method, .step = 2e-3});
    REQUIRE(simulation.step(1500).ok());
    CHECK(position(simulation, 3).y() ==
          doctest::Approx(6.0 * radius - (1.0 + 2.0 + 3.0) * weight / stiffness).epsilon(1e-6));
  }
}

TEST_CASE("the derivative of two grains' forces is that of their differences") {
  Scene scene;
  const Vec3 apart = (2.0 - 1e-7) * radius * Vec3(1.0, -2.0, 0.5).normalized();
  scene.add_particle(mass, Vec3::Zero());
  scene.add_particle(mass, apart);
  scene.effects = {ParticleContact{
      .radius = {radius}, .stiffness = stiffness, .shear_stiffness = 0.3 * stiffness, .friction = 1e9}};
  ForcesOfScene forces(scene);
  forces.state().pairs[0] = {{0, 1, {-apart.x(), -apart.y(), -apart.z()}}};
  Eigen::VectorXd direction(6);
  direction << 0.3, -0.4, 0.9, 0.5, 0.2, -0.1;
  const Eigen::VectorXd product = forces.product(direction, {1.0, 0.0}, Curvature::convex);
  const Eigen::VectorXd x = forces.positions();
  const auto force_at = [&](double step) {
    forces.set_positions(x + step * direction);
    return forces.forces_at_time(0.0);
  };
  const double h = 1e-10;  // [m], so that they still touch
  const Eigen::VectorXd difference = -(force_at(h) - force_at(-h)) / (2.0 * h);
  CHECK((product - difference).norm() < 1e-4 * product.norm());
}

TEST_CASE("bad grains are refused by what is wrong with them") {
  Scene scene = cloud(3, 1.0, 1);
  const auto first_problem = [&](const ParticleContact& contact) {
    scene.effects = {contact};
    const std::vector<Fault> faults = validate(scene);
    return faults.empty() ? std::string() : faults.front().message();
  };
  CHECK(first_problem({}).find("0 radii of 3 particles") != std::string::npos);
  CHECK(first_problem({.radius = {0.1, 0.1}}).find("2 radii of 3 particles") != std::string::npos);
  CHECK(first_problem({.radius = {0.1, 0.0, 0.1}}).find("radius[1] is 0") != std::string::npos);
  CHECK(first_problem({.radius = {NAN}}).find("radius[0]") != std::string::npos);
  CHECK(first_problem({.radius = {0.1}, .stiffness = -1.0}).find("stiffness is -1") != std::string::npos);
  CHECK(first_problem({.radius = {0.1}, .friction = -1.0}).find("friction is -1") != std::string::npos);
  CHECK(first_problem({.radius = {0.1}, .particles = {7}}).find("particles[0] is 7") != std::string::npos);
  CHECK(first_problem({.radius = {0.1}, .particles = {1, 1}}).find("named before") != std::string::npos);
  CHECK(first_problem({.radius = {0.1}, .particles = {1, 2}}).empty());
}
