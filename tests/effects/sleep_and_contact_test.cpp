// What sleeps and what it touches: solids that carry it, what hits it, what feels it.

#include <doctest/doctest.h>

#include <hooke/hooke.h>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double radius = 0.01;

template <class Real>
void step_until_asleep(Simulation<Real>& simulation, Index particle) {
  for (int i = 0; i < 400 && !simulation.is_asleep(particle); ++i) REQUIRE(simulation.step().ok());
  REQUIRE(simulation.is_asleep(particle));
}

}  // namespace

TEST_CASE("sleepers are felt where they are by a run that was restored") {
  // Whole blocks of grains slide aside and fall asleep; one more is then pushed through where they were.
  Scene scene;
  const Index one = 48;
  for (Index i = 0; i < one; ++i) scene.add_particle(0.01, {0.05 + 0.03 * i, radius, 0.0}, {0.0, 0.0, 1.0});
  scene.add_particle(0.01, {-0.03, radius, 0.0});
  scene.effects = {Gravity{}, Collider{.shape = PlaneShape{}, .thickness = radius, .friction = 0.5},
                   ParticleContact{.radius = {radius}, .stiffness = 100.0, .damping = 0.1},
                   Sleep{.speed = 2e-3, .time = 0.05}};
  for (const Method& method : {Method(SymplecticEuler{}), Method(RungeKutta4{}), Method(Verlet{}),
                               Method(BackwardEuler{}), Method(Xpbd{}), Method(VertexBlockDescent{})}) {
    CAPTURE(to_string(method));
    const Settings settings{.method = method, .step = 2e-3, .threads = 1};
    Simulation<double> whole(scene, settings), restored(scene, settings);
    step_until_asleep(whole, 0);
    step_until_asleep(whole, one);
    REQUIRE(position(whole, 0).z() > 0.08);
    restored.restore(whole.snapshot());
    for (Simulation<double>* simulation : {&whole, &restored}) {
      simulation->apply_impulse(one, {0.01, 0.0, 0.0});
      REQUIRE(simulation->step(100).ok());
    }
    CHECK(position(whole, one).x() > 0.06);
    CHECK(whole.is_asleep(0));
    CHECK(restored.state_hash() == whole.state_hash());
  }
}
