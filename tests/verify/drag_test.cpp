#include <doctest/doctest.h>

#include <cmath>

#include "scenes.h"
#include "verify/method_theory.h"
#include "verify/order.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double mass = 0.8, drag = 1.6, rate = drag / mass;
const Vec3 gravity(0.0, -9.81, 0.0), start(1.0, 2.0, 3.0), speed(6.0, 4.0, -1.0);

/// Errors in position and velocity after 1 s of fall in air that moves with `wind` [m/s].
struct FallError {
  double position, velocity;
};

FallError fall_error(const Method& method, double h, const Vec3& wind) {
  Scene scene;
  scene.add_particle(mass, start, speed);
  scene.effects = {Gravity{gravity}, Drag{drag}};
  // Still air moving along: F = -c (v - u).
  if (!wind.isZero())
    scene.effects.push_back(Field{[wind](const Vec3&, double) { return Vec3(drag * wind); }});
  Simulation<double> simulation(scene, {.method = method, .step = h, .threads = 1});
  REQUIRE(simulation.step(std::uint64_t(std::lround(1.0 / h))).ok());
  const Vec3 terminal = wind + gravity / rate;
  const double decay = std::exp(-rate);
  const Vec3 v = terminal + decay * (speed - terminal);
  const Vec3 x = start + terminal + (1.0 - decay) / rate * (speed - terminal);
  return {(position(simulation, 0) - x).norm(), (velocity(simulation, 0) - v).norm()};
}

}  // namespace

TEST_CASE("fall with drag, in still air and in wind, converges to its closed form with each method's order") {
  for (const MethodTheory& theory : methods()) {
    CAPTURE(theory.name());
    const int order = theory.order_with_damping();
    for (const Vec3& wind : {Vec3(0, 0, 0), Vec3(3, 0, 1)}) {
      std::vector<double> positions, velocities;
      for (double h = order == 4 ? 0.05 : 0.01; positions.size() < 5; h /= 2.0) {
        const FallError error = fall_error(theory.method, h, wind);
        positions.push_back(error.position);
        velocities.push_back(error.velocity);
      }
      CHECK(std::abs(order_of(positions) - order) < 0.1);
      CHECK(std::abs(order_of(velocities) - order) < 0.1);
      CHECK(positions.back() < (order == 1 ? 1e-2 : order == 2 ? 1e-5 : 1e-10));
      MESSAGE(theory.name() << std::string(wind.isZero() ? ", still air" : ", wind") << ": order "
                            << order_of(positions) << " in position, " << order_of(velocities)
                            << " in velocity, last error " << positions.back() << " m");
    }
  }
}
