#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include <hooke/hooke.h>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

TEST_CASE("a particle falls in uniform wind as the closed form says, by every way that air can move alike") {
  constexpr double mass = 0.8, coefficient = 1.6, rate = coefficient / mass;
  const Vec3 g(0.0, -9.81, 0.0), u(3.0, 0.0, 1.0), v0(6.0, 4.0, -1.0);
  for (const FieldShape& velocity :
       {FieldShape(UniformField{u}), FieldShape(CallbackField{[u](const Vec3&, double) { return u; }}),
        FieldShape(GridField{.values = {u}})}) {
    Scene scene;
    scene.add_particle(mass, {1, 2, 3}, v0);
    scene.effects = {Gravity{g}, ParticleWind{coefficient, velocity}};
    Simulation<double> simulation(scene, {.method = RungeKutta4{}, .step = 0.01});
    REQUIRE(simulation.step(100).ok());
    const Vec3 terminal = u + g / rate;
    CHECK((hooke::test::velocity(simulation, 0) - terminal - std::exp(-rate) * (v0 - terminal)).norm() <
          1e-8);
    const Vec3 way = terminal + (1.0 - std::exp(-rate)) / rate * (v0 - terminal);
    CHECK((position(simulation, 0) - Vec3(1, 2, 3) - way).norm() < 1e-8);
  }
}

TEST_CASE("wind that swells: the velocity follows the envelope as the closed form says") {
  // dv/dt = rate (u t - v), from rest: v = u (t - (1 - exp(-rate t)) / rate).
  constexpr double rate = 3.0;
  Scene scene;
  scene.add_particle(1.0, {0, 0, 0});
  scene.effects = {ParticleWind{rate, UniformField{{2, 0, 0}}, RampEnvelope{.end = 10.0, .to = 10.0}}};
  Simulation<double> simulation(scene, {.method = RungeKutta4{}, .step = 0.01});
  REQUIRE(simulation.step(200).ok());
  CHECK(velocity(simulation, 0).x() == doctest::Approx(2.0 * (2.0 - (1.0 - std::exp(-6.0)) / rate)));
}

TEST_CASE("a light particle in a vortex goes round with it") {
  constexpr double rate = 2.0, radius = 0.5, coefficient = 400.0;
  const double turn = 2.0 * std::numbers::pi / rate;
  Scene scene;
  scene.add_particle(1.0, {radius, 0, 0}, {0, rate * radius, 0});
  scene.effects = {ParticleWind{coefficient, VortexField{.axis = {0, 0, 1}, .rate = rate}}};
  Simulation<double> simulation(scene, {.method = RungeKutta4{}, .step = turn / 4000});
  REQUIRE(simulation.step(4000).ok());
  // It is thrown outwards at the speed m rate^2 r / c: here 1 % of the way that it goes in a radian.
  const double outwards = std::exp(rate * rate / coefficient * turn);
  CHECK((position(simulation, 0) - Vec3(radius * outwards, 0, 0)).norm() < 1e-3 * radius);
  CHECK(std::abs(velocity(simulation, 0).norm() - rate * radius * outwards) < 1e-3);
}

TEST_CASE("strong wind bounds the step, and implicit methods take it whole") {
  Scene scene;
  scene.add_particle(1.0, {0, 0, 0});
  scene.effects = {ParticleWind{1e4, UniformField{{1, 2, 3}}}};
  CHECK(highest_damping_rate(scene) == doctest::Approx(1e4));
  Simulation<double> simulation(scene, {.method = BackwardEuler{}, .step = 0.1});
  REQUIRE(simulation.step(5).ok());
  CHECK(velocity(simulation, 0).isApprox(Vec3(1, 2, 3), 1e-6));
}

TEST_CASE("wind on particles with a coefficient of zero is none, to the bit") {
  Scene bare = hung_cloth(20, 20), zero = bare;
  zero.effects.push_back(ParticleWind{0.0, TurbulenceField{}});
  Simulation<float> a(bare, {.step = 1e-3}), b(zero, {.step = 1e-3});
  REQUIRE(a.step(100).ok());
  REQUIRE(b.step(100).ok());
  CHECK(a.state_hash() == b.state_hash());
}
