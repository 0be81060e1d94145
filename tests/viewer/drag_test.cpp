#include <doctest/doctest.h>

#include <cmath>

#include "scenes.h"
#include "viewer/live/live_simulation.h"
#include "viewer/live/step_limit.h"

namespace hooke::viewer {
namespace {

template <class Real>
double distance(const LiveSimulation<Real>& live, Index particle, const Vec3& target) {
  return (test::position(live.simulation(), particle) - target).norm();
}

/// Nine tenths of what is stable; of methods for which nothing is, so short a step that they grow slowly.
double long_step(const Scene& scene, const Method& method) {
  const auto limit = step_limit(scene, method);
  if (!limit) return 1e-3;
  return limit->step > 0.0 ? 0.9 * limit->step : 1e-5;
}

}  // namespace

TEST_CASE("a step of the drag spring is one of implicit Euler") {
  const DragSpring spring{50.0, 3.0};
  const double mass = 0.2, h = 0.1;
  const Vec3 offset(1.0, -0.5, 2.0), velocity(0.3, 0.0, -4.0);
  const Vec3 after = velocity + drag_impulse(spring, mass, h, offset, velocity) / mass;
  // m (v' - v) = h (k (d - h v') - c v')
  const Vec3 residual =
      mass * (after - velocity) - h * (spring.stiffness * (offset - h * after) - spring.damping * after);
  CHECK(residual.norm() < 1e-12);
}

TEST_CASE("a particle on a drag spring alone comes to rest at the mouse, however stiff and long the step") {
  for (const double h : {1e-4, 1e-2, 1.0}) {
    for (const double stiffness : {0.1, 1e3, 1e9}) {
      const DragSpring spring{stiffness, 2.0 * std::sqrt(stiffness)};  // critical for 1 kg
      Vec3 position = Vec3::Zero(), velocity(5, 0, 0);
      const Vec3 target(1, 2, 3);
      const auto steps = static_cast<int>(30.0 / (h * std::sqrt(stiffness))) + 200;
      for (int i = 0; i < steps; ++i) {
        velocity += drag_impulse(spring, 1.0, h, target - position, velocity);
        position += h * velocity;
        REQUIRE((position - target).norm() < 50.0);
      }
      CHECK((position - target).norm() < 1e-3);
    }
  }
}

TEST_CASE("a drag spring lifts a scene, and is the softer the longer the step") {
  const Scene scene = test::hung_cloth(16, 16);
  const double mass = scene.particles.mass[0];
  const DragSpring fine = drag_spring(scene, mass, 1e-5), coarse = drag_spring(scene, mass, 1e-2);
  CHECK(fine.stiffness > coarse.stiffness);
  CHECK(coarse.stiffness * 1e-4 <= mass / 49.0);
  CHECK(coarse.damping * 1e-2 <= mass / 19.0);
}

TEST_CASE("dragging pulls a particle towards the mouse and stays stable with every method near its limit") {
  const Scene scene = test::hung_cloth(12, 12, 1e-4);
  const Index dragged = 12 * 12 - 6;
  const Vec3 target = scene.particles.position[dragged] + Vec3(0.05, 0.1, 0.1);
  for (const Method& method : all_methods) {
    CAPTURE(to_string(method));
    Settings settings;
    settings.method = method;
    settings.step = long_step(scene, method);
    settings.threads = 1;
    LiveSimulation<float> live(scene, settings);
    const double before = distance(live, dragged, target);
    live.drag({dragged, target});
    Work work;
    const auto steps = static_cast<std::uint64_t>(std::min(0.5 / settings.step, 20000.0));
    const Report report = live.take_steps(steps, work);
    CHECK(report.ok());
    CHECK(work.steps == steps);
    CHECK(distance(live, dragged, target) < 0.7 * before);
    CHECK(live.simulation().max_strain() < 3.0);
  }
}

TEST_CASE("what is let go of is pulled no more; a pinned particle stays") {
  Scene scene = test::one_particle();
  scene.add_particle(1.0, Vec3(1, 0, 0));
  scene.pin(1);
  Settings settings;
  settings.step = 1e-3;
  LiveSimulation<double> live(scene, settings);
  Work work;
  live.drag({0, Vec3(0, 1, 0)});
  live.take_steps(10, work);
  live.release();
  const Vec3 velocity = test::velocity(live.simulation(), 0);
  CHECK(velocity.y() > 0.0);
  live.take_steps(10, work);
  CHECK(test::velocity(live.simulation(), 0) == velocity);
  live.drag({1, Vec3(0, 1, 0)});
  live.take_steps(10, work);
  CHECK(test::position(live.simulation(), 1) == Vec3(1, 0, 0));
  CHECK_THROWS_AS(live.drag({2, Vec3::Zero()}), std::out_of_range);
}

TEST_CASE("the limit on steps holds where the engine's stability number says so") {
  const Scene scene = test::hung_cloth(8, 8);
  const auto limit = step_limit(scene, SymplecticEuler{});
  REQUIRE(limit);
  const Index lowest = 8 * 8 - 1;
  const auto drift = [&](double step) {
    Simulation<double> simulation(
        scene, {.method = SymplecticEuler{}, .step = step, .unstable_step = UnstableStep::take});
    const Report report = simulation.step(20000);
    return report.ok() ? (test::position(simulation, lowest) - scene.particles.position[lowest]).norm()
                       : 1e30;
  };
  CHECK(drift(0.95 * limit->step) < 1.0);
  CHECK(drift(2.0 * limit->step) > 1e3);
  CHECK_FALSE(step_limit(scene, DormandPrince{}));
  CHECK(step_limit(scene, Heun{})->step == 0.0);
  CHECK_FALSE(step_limit(test::one_particle(), Verlet{}));
}

}  // namespace hooke::viewer
