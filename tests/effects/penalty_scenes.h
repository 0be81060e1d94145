#pragma once

#include <cmath>

#include <hooke/scene.h>

namespace hooke::test {

constexpr double g = 9.81, mass = 0.3;

/// A particle in gravity, and a collider.
inline Scene one_over(const Collider& collider, const Vec3& place, const Vec3& velocity = Vec3::Zero()) {
  Scene scene;
  scene.add_particle(mass, place, velocity);
  scene.effects = {Gravity{{0.0, -g, 0.0}}, collider};
  return scene;
}

/// A plane that rises to the right by an angle.
inline Collider incline(double angle, double friction) {
  return {.shape = PlaneShape{{-std::sin(angle), std::cos(angle), 0.0}},
          .friction = friction,
          .stiffness = 1e5,
          .damping = 200.0};
}

}  // namespace hooke::test
