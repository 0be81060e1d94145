#pragma once

#include <random>
#include <utility>
#include <vector>

#include "scenes.h"

namespace hooke::test {

/// A cloth hung by two corners whose particles have been thrown about by up to `share` of its spacing, after
/// it was pressed or stretched by `factor` along x.
inline Scene disturbed_cloth(double factor, double share, double damping = 0.0, std::uint32_t seed = 1) {
  Scene scene = hung_cloth(17, 13, damping);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (Vec3& position : scene.particles.position) {
    position.x() *= factor;
    position += 0.02 * share * Vec3(unit(random), unit(random), unit(random));
  }
  scene.particles.velocity.resize(scene.particles.size());
  for (Vec3& velocity : scene.particles.velocity) velocity = Vec3(unit(random), unit(random), unit(random));
  return scene;
}

/// Scenes in which something is zero, empty or all in one place, each with what it is.
inline std::vector<std::pair<const char*, Scene>> degenerate_scenes() {
  std::vector<std::pair<const char*, Scene>> scenes;
  scenes.emplace_back("no particles", Scene{});
  scenes.emplace_back("one particle", one_particle());
  {
    Scene scene = hung_cloth(5, 5);
    for (Index i = 0; i < scene.particles.size(); ++i) {
      if (i != 0 && i != 4) scene.pin(i);
    }
    scenes.emplace_back("all pinned", scene);
  }
  {
    Scene scene = hung_cloth(5, 5);
    for (double& stiffness : scene.springs.stiffness) stiffness = 0.0;
    scenes.emplace_back("no stiffness", scene);
  }
  {
    Scene scene = hung_cloth(5, 5, 0.01);
    for (Vec3& position : scene.particles.position) position = Vec3::Zero();
    scenes.emplace_back("all in one place", scene);
    for (double& length : scene.springs.rest_length) length = 0.0;
    scenes.emplace_back("all in one place, without rest lengths", scene);
    for (double& length : scene.springs.rest_length) length = 1e-38;
    scenes.emplace_back("all in one place, rest lengths of 1e-38 m", scene);
  }
  {
    Scene scene;
    for (Index i = 0; i < 40; ++i) scene.add_particle(1.0, Vec3(i, 0, 0), Vec3(0, 1, 0));
    for (Index i = 0; i < 40; i += 4) scene.add_spring(i, i + 1, 1e4, 0.5);
    for (Index i = 0; i < 40; i += 4) scene.add_spring(i + 1, i, 1e4, 0.5);
    scenes.emplace_back("pairs joined twice, and particles joined to nothing", scene);
  }
  {
    Scene scene;
    scene.add_particle(1.0, Vec3::Zero());
    for (Index i = 1; i < 200; ++i) {
      scene.add_particle(1e-3, Vec3(0.01 * i, 0, 0));
      scene.add_spring(0, i, 1e5, 0.3);
    }
    scene.effects = {Gravity{}, GroundPlane{.height = -0.01}};
    scenes.emplace_back("a hub", scene);
  }
  return scenes;
}

}  // namespace hooke::test
