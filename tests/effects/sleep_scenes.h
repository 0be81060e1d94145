#pragma once

#include <doctest/doctest.h>

#include <cstddef>

#include <hooke/hooke.h>

namespace hooke::test {

constexpr Index side = 8;
constexpr std::size_t of_cloth = side * side;       ///< its particles
constexpr double spacing = 0.02, thickness = 2e-3;  // [m]

/// A cloth that lies flat at a height; its particles begin at the one returned.
inline Index lay_cloth(Scene& scene, const Vec3& place) {
  ClothGrid cloth{.columns = side, .rows = side, .spacing = spacing, .areal_density = 0.5, .stretch = 50.0};
  cloth.shear = 25.0, cloth.bend = 0.5, cloth.damping = 0.01;
  cloth.placement = {.translation = place, .rotation_axis = {1.0, 0.0, 0.0}, .rotation_degrees = -90.0};
  return add(scene, cloth).first;
}

/// A pendulum of which nothing slows but the stretch.
inline Index hang_pendulum(Scene& scene, const Vec3& place) {
  const Index pin = scene.add_particle(0.1, place);
  const Index bob = scene.add_particle(0.1, place + Vec3(0.3, 0.0, 0.0));
  scene.add_spring(pin, bob, 500.0, 0.3, 0.5);
  scene.pin(pin);
  return bob;
}

/// A floor for what is added, which sleeps when it has been at rest for so long [s].
inline Scene floor_with(double time = 0.2) {
  Scene scene;
  scene.effects = {Gravity{}, Collider{.shape = PlaneShape{}, .thickness = 1e-3, .friction = 0.5},
                   Sleep{.speed = 2e-3, .time = time}};
  return scene;
}

/// Two cloths on the floor, and a pendulum.
struct Resting {
  Scene scene = floor_with();
  Index first, second, bob;

  Resting() {
    first = lay_cloth(scene, {0.0, 1e-3, 0.0});
    second = lay_cloth(scene, {0.5, 1e-3, 0.0});
    bob = hang_pendulum(scene, {0.0, 1.0, 1.0});
  }
};

/// How many particles sleep.
inline std::size_t asleep(const Report& report) {
  return std::size_t(report.particles_asleep);
}

/// A run of a scene that has so many particles asleep, within a second.
template <class Real>
Simulation<Real> asleep_after(const Scene& scene, std::size_t particles) {
  constexpr int most = 200;
  Simulation<Real> simulation(scene, {.method = SymplecticEuler{}, .step = 5e-3, .threads = 1});
  for (int i = 0; i < most; ++i) {
    if (asleep(simulation.step()) == particles) return simulation;
  }
  FAIL("not asleep after " << most << " steps");
  return simulation;
}

}  // namespace hooke::test
