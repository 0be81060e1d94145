#include <doctest/doctest.h>

#include <cmath>

#include <Eigen/Geometry>

#include "verify/method_theory.h"
#include "verify/order.h"
#include "verify/tensioned_net.h"

using namespace hooke;
using namespace hooke::test;

namespace {

Scene free_network(std::uint32_t seed) {
  Scene scene = RandomNetwork(seed).make();
  scene.pins.clear();
  return scene;
}

/// Sum of the sizes of all momenta [kg m/s]: what round-off in their sum is measured against.
double momentum_scale(const Scene& scene, const Simulation<double>& simulation) {
  double sum = 0.0;
  for (Index i = 0; i < scene.particles.size(); ++i) {
    sum += scene.particles.mass[i] * velocity(simulation, i).norm();
  }
  return sum;
}

Vec3 angular_momentum(const Scene& scene, const Simulation<double>& simulation) {
  Vec3 sum = Vec3::Zero();
  for (Index i = 0; i < scene.particles.size(); ++i)
    sum += scene.particles.mass[i] * position(simulation, i).cross(velocity(simulation, i));
  return sum;
}

}  // namespace

TEST_CASE("springs change no linear momentum, but for round-off") {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const Scene scene = free_network(seed);
    const std::vector<MethodTheory> all = methods();
    const MethodTheory& theory = all[seed % all.size()];
    CAPTURE(theory.name());
    for (auto accumulation : accumulations) {
      Simulation<double> simulation(scene,
                                    {.method = theory.method, .step = 1e-3, .accumulation = accumulation});
      const Vec3 before = simulation.momentum();
      REQUIRE(simulation.step(100).ok());
      CHECK((simulation.momentum() - before).norm() < 1e-13 * 100 * momentum_scale(scene, simulation));
    }
  }
}

TEST_CASE("the two ends of one spring get opposite bits") {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    Scene scene;
    std::mt19937 random(seed);
    std::normal_distribution<double> any;
    for (int i = 0; i < 2; ++i) {
      scene.add_particle(1.0, {any(random), any(random), any(random)}, {0, 0, 0});
    }
    scene.add_spring(0, 1, std::exp(any(random)), std::exp(any(random)));
    Simulation<float> simulation(scene, {.step = 1.0});
    REQUIRE(simulation.step().ok());
    CHECK(velocity(simulation, 0) == -velocity(simulation, 1));
    CHECK_FALSE(velocity(simulation, 0).isZero());
  }
}

TEST_CASE("splitting methods keep the angular momentum of an undamped network") {
  for (const MethodTheory& theory : splitting_methods()) {
    CAPTURE(theory.name());
    double worst = 0.0;
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
      Scene scene = free_network(seed);
      scene.springs.damping.clear();
      Simulation<double> simulation(scene, {.method = theory.method, .step = 1e-3});
      const Vec3 before = angular_momentum(scene, simulation);
      REQUIRE(simulation.step(500).ok());
      const double change = (angular_momentum(scene, simulation) - before).norm();
      CHECK(change < 1e-10 * (1.0 + momentum_scale(scene, simulation)));
      worst = std::max(worst, change / (1.0 + momentum_scale(scene, simulation)));
    }
    MESSAGE(theory.name() << ": changed by " << worst << " of the sum of momenta");
  }
}

TEST_CASE("explicit Euler adds h^2 sum v x F to the angular momentum each step") {
  const double h = 0.01;
  Scene scene = tensioned_net();
  Simulation<double> simulation(scene, {.method = ExplicitEuler{}, .step = h, .threads = 1});
  for (int n = 0; n < 20; ++n) {
    const Vec3 before = angular_momentum(scene, simulation);
    std::vector<Vec3> old_velocity;
    for (Index i = 0; i < scene.particles.size(); ++i) old_velocity.push_back(velocity(simulation, i));
    REQUIRE(simulation.step().ok());
    Vec3 gain = Vec3::Zero();
    for (Index i = 0; i < scene.particles.size(); ++i) {
      const Vec3 impulse = scene.particles.mass[i] * (velocity(simulation, i) - old_velocity[i]);  // h F
      gain += h * old_velocity[i].cross(impulse);
    }
    CHECK(gain.norm() > 1e-6);
    CHECK((angular_momentum(scene, simulation) - before - gain).norm() < 1e-13);
  }
}

TEST_CASE("the angular momentum that a Runge-Kutta step adds falls with its order and one more") {
  for (const MethodTheory& theory : splitting_methods(false)) {
    CAPTURE(theory.name());
    std::vector<double> changes;
    for (double h = 0.04; changes.size() < 5; h /= 2.0) {
      const Scene scene = tensioned_net();
      Simulation<double> simulation(scene, {.method = theory.method, .step = h, .threads = 1});
      const Vec3 before = angular_momentum(scene, simulation);
      REQUIRE(simulation.step().ok());
      changes.push_back((angular_momentum(scene, simulation) - before).norm());
    }
    CHECK(order_of(changes) > theory.order + 0.9);
    MESSAGE(theory.name() << ": adds " << changes.front() << " to " << changes.back() << " kg m^2/s, order "
                          << order_of(changes));
  }
}
