#include <doctest/doctest.h>

#include <cmath>
#include <optional>

#include <hooke/hooke.h>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double g = 9.81, h = 1e-3, held = 0.02;

/// A particle that hangs on a damped spring, and starts off its place of rest.
Scene on_spring(double mass, double damping) {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  scene.add_particle(mass, {0.0, -1.05, 0.0});
  scene.add_spring(0, 1, 20.0, 1.0, damping);
  scene.pin(0);
  scene.effects = {Gravity{{0.0, -g, 0.0}}};
  return scene;
}

/// The same with a body of the host's at the particle, whose mass is the rest of what hangs.
struct Coupled {
  explicit Coupled(double body, double damping) : mass(body) {
    Scene scene = on_spring(held, damping);
    scene.effects.push_back(FrameAttachment{.particles = {1}, .origin = scene.particles.position[1]});
    simulation.emplace(scene, Settings{.step = h});
  }

  bool step(const Vec3& force, double moved_mass) {
    velocity += h / moved_mass * (force + Vec3(0, -mass * g, 0));
    displacement += h * velocity;
    if (!(displacement.norm() < 1e6)) return false;
    simulation->move_frame(1, {displacement, Eigen::Quaterniond::Identity()});
    return simulation->step(1).ok();
  }

  double mass;
  Vec3 velocity = Vec3::Zero(), displacement = Vec3::Zero();
  std::optional<Simulation<double>> simulation;
};

}  // namespace

TEST_CASE(
    "a body that takes the pull on its frame moves as if its mass were the particle's, light or heavy") {
  for (const double mass : {held / 100.0, held, 100.0 * held}) {
    CAPTURE(mass);
    Coupled coupled(mass, 0.0);
    Simulation<double> whole(on_spring(mass + held, 0.0), {.step = h});
    for (int i = 0; i < 5000; ++i) {
      REQUIRE(coupled.step(coupled.simulation->pull_on_frame(1).force, mass + held));
      REQUIRE(whole.step(1).ok());
    }
    CHECK((position(*coupled.simulation, 1) - position(whole, 1)).norm() < 1e-9);
  }
}

TEST_CASE("with the force of the last step a body must be heavier than what is attached to it") {
  const auto comes_to_rest = [](double mass) {
    Coupled coupled(mass, 0.5);
    for (int i = 0; i < 20000; ++i) {
      if (!coupled.step(coupled.simulation->carried_force(1).force, mass)) return false;
    }
    const double rest = 1.0 + (mass + held) * g / 20.0;
    return std::abs(-position(*coupled.simulation, 1).y() - rest) < 1e-6;
  };
  CHECK(comes_to_rest(10.0 * held));
  CHECK(comes_to_rest(1.25 * held));
  CHECK_FALSE(comes_to_rest(0.8 * held));
  CHECK_FALSE(comes_to_rest(0.1 * held));
}
