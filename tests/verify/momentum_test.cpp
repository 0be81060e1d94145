#include <doctest/doctest.h>

#include <cmath>

#include <Eigen/Geometry>

#include "scenes.h"

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

}  // namespace

TEST_CASE("springs change no linear momentum, but for round-off") {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const Scene scene = free_network(seed);
    for (auto accumulation : accumulations) {
      Simulation<double> simulation(scene, {.step = 1e-3, .accumulation = accumulation});
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

TEST_CASE("symplectic Euler keeps the angular momentum of an undamped network") {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Scene scene = free_network(seed);
    scene.springs.damping.clear();
    Simulation<double> simulation(scene, {.step = 1e-3});
    const auto angular = [&] {
      Vec3 sum = Vec3::Zero();
      for (Index i = 0; i < scene.particles.size(); ++i) {
        sum += scene.particles.mass[i] * position(simulation, i).cross(velocity(simulation, i));
      }
      return sum;
    };
    const Vec3 before = angular();
    REQUIRE(simulation.step(500).ok());
    CHECK((angular() - before).norm() < 1e-10 * (1.0 + momentum_scale(scene, simulation)));
  }
}
