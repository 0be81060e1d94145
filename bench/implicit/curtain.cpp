#include "implicit/curtain.h"

#include <stdexcept>

namespace hooke::bench {
namespace {

constexpr Index side = 81;

Index at(Index i, Index j) {
  return j * side + i;
}

std::vector<Vec3> vectors_of(const std::vector<double>& values) {
  std::vector<Vec3> vectors(values.size() / 3);
  for (std::size_t i = 0; i < vectors.size(); ++i)
    vectors[i] = Vec3(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
  return vectors;
}

}  // namespace

Scene liu_curtain(double stiffness) {
  Scene scene;
  scene.name = "curtain";
  const double spacing = 1.0 / (side - 1);
  for (Index j = 0; j < side; ++j) {
    for (Index i = 0; i < side; ++i) scene.add_particle(1.0 / (side * side), {i * spacing, 0.0, j * spacing});
  }
  const auto join = [&](Index a, Index b) {
    const std::vector<Vec3>& x = scene.particles.position;
    scene.add_spring(a, b, stiffness, (x[a] - x[b]).norm());
  };
  for (Index j = 0; j < side; ++j) {
    for (Index i = 0; i < side; ++i) {
      for (Index further : {1u, 2u}) {
        if (i + further < side) join(at(i, j), at(i + further, j));
        if (j + further < side) join(at(i, j), at(i, j + further));
      }
      if (i + 1 < side && j + 1 < side) join(at(i, j), at(i + 1, j + 1));
    }
  }
  scene.pin(at(0, 0));
  scene.pin(at(side - 1, 0));
  scene.effects = {Gravity{}};
  return scene;
}

std::vector<Vec3> Frame::positions() const {
  return vectors_of(start.positions);
}

std::vector<Vec3> Frame::velocities() const {
  return vectors_of(start.velocities);
}

Frame curtain_frame(double stiffness) {
  constexpr double h = 1.0 / 30.0;
  constexpr std::uint64_t frames = 30;
  const Scene scene = liu_curtain(stiffness);
  Simulation<double> simulation(scene,
                                {.method = ProjectiveDynamics{.iterations = 10, .history = 0}, .step = h});
  const Report report = simulation.step(frames);
  if (!report.ok()) throw std::runtime_error("the curtain does not come to its frame: " + report.message());
  return {scene, simulation.snapshot(), h};
}

}  // namespace hooke::bench
