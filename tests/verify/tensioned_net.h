#pragma once

#include "scenes.h"

namespace hooke::test {

/// A net of 4 x 4 particles, 0.5 m apart, whose springs are all longer than at rest, so that forces are
/// smooth; it moves by up to some tenths of a metre. w_max is about 20 /s.
inline Scene tensioned_net(double damping = 0.0) {
  Scene scene;
  const auto at = [](int i, int j) { return Index(4 * j + i); };
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i)
      scene.add_particle(0.4 + 0.02 * (i + 2 * j), {0.5 * i, 0.5 * j, 0.1 * (i * j % 3)},
                         {0.2 * (j % 2), 0.1 * (i % 3), 0.5 - 0.3 * (i % 2)});
  }
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      if (i < 3) scene.add_spring(at(i, j), at(i + 1, j), 25.0, 0.3, damping);
      if (j < 3) scene.add_spring(at(i, j), at(i, j + 1), 25.0, 0.3, damping);
      if (i < 3 && j < 3) scene.add_spring(at(i, j), at(i + 1, j + 1), 10.0, 0.5, damping);
    }
  }
  return scene;
}

/// The net hung by its corners in gravity, and shaken.
inline Scene shaken_net(double damping = 0.0) {
  Scene scene = tensioned_net(damping);
  for (Index corner : {0u, 3u, 12u, 15u}) scene.pin(corner);
  scene.effects = {Gravity{{0.0, 0.0, -9.81}}, Field{[](const Vec3& x, double t) {
                     return Vec3(0.5 * std::cos(7.0 * t), 0.3 * x.z() * std::sin(3.0 * t), 0.2 * x.x());
                   }}};
  if (damping > 0.0) scene.effects.push_back(Drag{damping});
  return scene;
}

}  // namespace hooke::test
