// What the motion of a network must not depend on: the direction of time, where it is, how it is turned, and
// how fast all of it moves.

#include <doctest/doctest.h>

#include <cmath>

#include <Eigen/Geometry>

#include "verify/method_theory.h"
#include "verify/tensioned_net.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// The largest distance [m] of a particle from where it was, after steps forward and as many with velocities
/// turned round.
double distance_from_start(const Method& method, std::uint64_t steps) {
  Scene scene = tensioned_net();
  scene.pin(0);
  scene.particles.velocity[0].setZero();
  scene.effects = {Gravity{{0.0, 0.0, -9.81}}};
  Simulation<double> simulation(scene, {.method = method, .step = 0.01, .threads = 1});
  REQUIRE(simulation.step(steps).ok());
  double moved = 0.0;
  for (Index i = 0; i < scene.particles.size(); ++i)
    moved = std::max(moved, (position(simulation, i) - scene.particles.position[i]).norm());
  REQUIRE(moved > 0.1);
  Snapshot<double> turned = simulation.snapshot();
  for (double& v : turned.velocities) v = -v;
  simulation.restore(turned);
  REQUIRE(simulation.step(steps).ok());
  double worst = 0.0;
  for (Index i = 0; i < scene.particles.size(); ++i) {
    worst = std::max(worst, (position(simulation, i) - scene.particles.position[i]).norm());
    worst = std::max(worst, 0.01 * (velocity(simulation, i) + scene.particles.velocity[i]).norm());
  }
  return worst;
}

}  // namespace

TEST_CASE("Verlet's and Blanes and Moan's methods go back the way they came, and others do not") {
  for (const MethodTheory& theory : methods()) {
    CAPTURE(theory.name());
    const bool symmetric = theory.splitting && theory.order > 1;
    const double distance = distance_from_start(theory.method, 500);
    if (symmetric) {
      CHECK(distance < 1e-11);
    } else {
      CHECK(distance > 1e-8);
    }
    MESSAGE(theory.name() << ": " << distance << " m from the start");
  }
}

TEST_CASE("a network that is turned, moved and boosted does the same, with each method") {
  const Eigen::AngleAxisd turn(1.1, Vec3(0.3, -0.5, 0.9).normalized());
  const Vec3 place(3.0, -2.0, 1.0), boost(0.7, 0.4, -1.3);
  const double h = 0.01;
  const std::uint64_t steps = 300;
  for (const MethodTheory& theory : methods()) {
    CAPTURE(theory.name());
    const Scene scene = tensioned_net(0.2);
    Scene other = scene;
    for (Vec3& x : other.particles.position) x = turn * x + place;
    for (Vec3& v : other.particles.velocity) v = turn * v + boost;
    for (auto accumulation : accumulations) {
      const Settings settings{.method = theory.method, .step = h, .accumulation = accumulation, .threads = 1};
      Simulation<double> one(scene, settings), two(other, settings);
      REQUIRE(one.step(steps).ok());
      REQUIRE(two.step(steps).ok());
      double worst = 0.0;
      for (Index i = 0; i < scene.particles.size(); ++i) {
        const Vec3 expected = turn * position(one, i) + place + double(steps) * h * boost;
        worst = std::max(worst, (position(two, i) - expected).norm());
      }
      CHECK(worst < 1e-11);
      if (accumulation == Accumulation::gather) MESSAGE(theory.name() << ": " << worst << " m apart");
    }
  }
}
