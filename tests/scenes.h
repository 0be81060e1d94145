#pragma once

#include <cstdint>
#include <random>

#include <hooke/hooke.h>

/// Scenes that several tests use.

namespace hooke::test {

/// A cloth hung by two corners, in gravity and drag; stable with steps of 1 ms.
inline Scene hung_cloth(Index columns, Index rows, double damping = 0.0) {
  Scene scene;
  const GridParticles cloth = add(scene, ClothGrid{.columns = columns,
                                                   .rows = rows,
                                                   .spacing = 0.02,
                                                   .areal_density = 2.0,
                                                   .stretch = 100.0,
                                                   .shear = 50.0,
                                                   .bend = 1.0,
                                                   .damping = damping});
  scene.pin(cloth.at(0, 0));
  scene.pin(cloth.at(columns - 1, 0));
  scene.effects = {Gravity{}, Drag{.coefficient = 1e-4}};
  return scene;
}

/// One particle of 1 kg at the origin, at rest.
inline Scene one_particle() {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  return scene;
}

/// A random network: any particle may be joined to any other, and the hard cases are all there: isolated
/// particles, duplicate springs, hubs of high degree, zero rest lengths, coincident particles, pins, with or
/// without damping.
class RandomNetwork {
 public:
  explicit RandomNetwork(std::uint32_t seed) : random_(seed) {}

  Scene make() {
    const Index particles = 1 + Index(random_() % 300);
    Scene scene;
    for (Index i = 0; i < particles; ++i) {
      scene.add_particle(0.5 + unit(), vector(), vector());
      if (i > 0 && random_() % 20 == 0) scene.particles.position[i] = scene.particles.position[i - 1];
    }
    if (particles > 1) add_springs(scene);
    for (Index i = 0; i < particles; ++i) {
      if (random_() % 25 == 0) scene.pin(i);
    }
    return scene;
  }

 private:
  void add_springs(Scene& scene) {
    const Index particles = Index(scene.particles.size());
    const bool damped = random_() % 2 == 0;
    const Index hub = Index(random_() % particles);
    const std::size_t springs = random_() % (4 * particles);
    for (std::size_t s = 0; s < springs; ++s) {
      // A third go to the hub, a third to near neighbours as in a grid, a third anywhere. A tenth of the
      // particles, those at the end, stay isolated.
      const Index joined = std::max<Index>(2, particles - particles / 10);
      const Index a = Index(random_() % joined);
      Index b = Index(random_() % joined);
      if (s % 3 == 0) b = hub;
      if (s % 3 == 1) b = (a + 7) % joined;
      if (a == b) continue;
      const double rest_length = random_() % 10 == 0 ? 0.0 : unit();
      const int copies = random_() % 15 == 0 ? 3 : 1;
      for (int c = 0; c < copies; ++c)
        scene.add_spring(a, b, 100.0 * unit(), rest_length, damped ? unit() : 0.0);
    }
  }

  double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
  Vec3 vector() { return {unit() - 0.5, unit() - 0.5, unit() - 0.5}; }

  std::mt19937 random_;
};

/// Position of one of the user's particles, from the state in the engine's order.
template <class Real>
Vec3 position(const Simulation<Real>& simulation, Index particle) {
  const Index e = simulation.engine_index(particle);
  const StateView<Real> state = simulation.state();
  return {double(state.x[e]), double(state.y[e]), double(state.z[e])};
}

template <class Real>
Vec3 velocity(const Simulation<Real>& simulation, Index particle) {
  const Index e = simulation.engine_index(particle);
  const StateView<Real> state = simulation.state();
  return {double(state.vx[e]), double(state.vy[e]), double(state.vz[e])};
}

}  // namespace hooke::test
