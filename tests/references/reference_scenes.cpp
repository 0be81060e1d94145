#include "reference_scenes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <span>

namespace hooke::test {
namespace {

double root_mean_square(std::span<const double> vectors) {
  const Eigen::Map<const Eigen::VectorXd> values(vectors.data(), Eigen::Index(vectors.size()));
  return std::sqrt(values.squaredNorm() / (double(values.size()) / 3.0));
}

/// The size and speed of a scene as DormandPrince takes them.
reference::Scale scale_of(const Scene& scene) {
  Eigen::AlignedBox3d box;
  for (const Vec3& x : scene.particles.position) box.extend(x);
  const double length = box.diagonal().norm();
  reference::EngineForces forces(scene);
  std::vector<double> derivative(forces.unknowns());
  forces.derivative(0.0, forces.start(), derivative);
  const std::span all(derivative);  // velocities, accelerations
  const double velocity = root_mean_square(all.first(all.size() / 2)),
               acceleration = root_mean_square(all.last(all.size() / 2));
  return {length, std::max({velocity, std::sqrt(acceleration * length), length / 1.0})};
}

ReferenceScene make(std::string name, Scene scene, double end) {
  const reference::Scale scale = scale_of(scene);
  return {std::move(name), std::move(scene), end, scale};
}

}  // namespace

ReferenceScene linear_network() {
  constexpr Index particles = 40;
  std::mt19937 random(7);
  const auto unit = [&] { return std::uniform_real_distribution<double>(0.0, 1.0)(random); };
  const auto vector = [&] { return Vec3(unit() - 0.5, unit() - 0.5, unit() - 0.5); };
  Scene scene;
  for (Index i = 0; i < particles; ++i) {
    const Vec3 place = vector();
    scene.add_particle(0.5 + unit(), place, 4.0 * vector());
  }
  for (Index i = 0; i < particles; ++i) {
    for (Index other : {i + 1, i + 5, i + 17})
      scene.add_spring(i, other % particles, 20.0 + 40.0 * unit(), 0.0);
  }
  for (Index i : {0u, 11u, 29u}) scene.pin(i);
  return make("network of zero rest lengths", std::move(scene), 2.0);
}

ReferenceScene taut_cloth() {
  constexpr Index n = 10;
  Scene scene;
  const GridParticles cloth = add(scene, ClothGrid{.columns = n,
                                                   .rows = n,
                                                   .spacing = 0.1,
                                                   .areal_density = 2.0,
                                                   .stretch = 100.0,
                                                   .shear = 50.0,
                                                   .bend = 5.0});
  scene.particles.velocity.resize(scene.particles.size(), Vec3::Zero());
  for (Vec3& x : scene.particles.position) x *= 1.1;
  for (Index row = 0; row < n; ++row) {
    for (Index column = 0; column < n; ++column) {
      const Index i = cloth.at(column, row);
      if (row == 0 || column == 0 || row == n - 1 || column == n - 1) {
        scene.pin(i);
      } else {
        const double phase = std::numbers::pi / (n - 1);
        scene.particles.velocity[i].z() = 2.0 * std::sin(phase * column) * std::sin(2.0 * phase * row);
      }
    }
  }
  scene.effects = {Gravity{}, Drag{.coefficient = 0.01}};
  return make("taut cloth", std::move(scene), 1.0);
}

ReferenceScene rope_pendulum() {
  Scene scene;
  const RopeParticles rope =
      add(scene, Rope{.particles = 12, .linear_density = 0.5, .stretch = 500.0, .bend = 5.0});
  scene.pin(rope.at(0));
  scene.effects = {Gravity{}};
  return make("rope pendulum", std::move(scene), 0.6);
}

ReferenceScene damped_block() {
  Scene scene;
  add(scene, Block{.nx = 4, .ny = 4, .nz = 4, .spacing = 0.1, .density = 200.0, .damping = 0.5});
  scene.particles.velocity.resize(scene.particles.size());
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    Vec3& x = scene.particles.position[i];
    scene.particles.velocity[i] = Vec3(1.0, 2.0, 0.0) + Vec3(0.0, 3.0, 5.0).cross(x);
    x.y() *= 0.9;
  }
  scene.effects = {Gravity{}};
  return make("damped block", std::move(scene), 0.5);
}

ReferenceScene pulled_rope() {
  Scene scene;
  const RopeParticles rope = add(scene, Rope{.particles = 12, .linear_density = 0.5, .stretch = 200.0});
  for (Vec3& x : scene.particles.position) x *= 1.2;
  scene.pin(rope.at(0));
  scene.pin(rope.at(11), {{0.0, {0, 0, 0}}, {0.5, {0, 0.3, 0}}, {1.0, {0.1, 0.3, 0.2}}});
  scene.effects = {Gravity{}, Drag{.coefficient = 0.02}};
  return make("rope pulled by a pin", std::move(scene), 1.0);
}

Error error_of(const std::vector<double>& y, const std::vector<double>& exact, const ReferenceScene& scene) {
  std::vector<double> difference(y.size());
  std::transform(y.begin(), y.end(), exact.begin(), difference.begin(), std::minus<>());
  const std::span all(difference);
  return {root_mean_square(all.first(all.size() / 2)) / scene.scale.length,
          root_mean_square(all.last(all.size() / 2)) / scene.scale.speed};
}

}  // namespace hooke::test
