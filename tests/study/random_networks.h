#pragma once

#include <cmath>
#include <random>
#include <tuple>
#include <vector>

#include <hooke/hooke.h>
#include <Eigen/Eigenvalues>

/// Small networks of any shape, and the derivatives of their forces written down once more, densely.

namespace hooke::test {

inline double uniform(std::mt19937& random) {
  return std::uniform_real_distribution<double>(0.0, 1.0)(random);
}

/// A few particles anywhere, joined in all ways, some pinned, some springs damped.
inline Scene random_network(std::mt19937& random, bool rest_lengths) {
  const auto vector = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
  Scene scene;
  const Index count = 2 + random() % 9;
  for (Index i = 0; i < count; ++i) scene.add_particle(0.01 + uniform(random), vector());
  for (Index s = 0; s < 3 * count; ++s) {
    const Index i = random() % count, j = random() % count;
    if (i == j) continue;
    const double stiffness = std::pow(10.0, 4.0 * uniform(random));
    scene.add_spring(i, j, stiffness, rest_lengths ? 2.0 * uniform(random) : 0.0,
                     random() % 2 == 0 ? uniform(random) * std::sqrt(stiffness) : 0.0);
  }
  if (random() % 2 == 0) scene.pin(0);
  if (random() % 2 == 0) scene.effects.push_back(Drag{uniform(random)});
  if (random() % 2 == 0)
    scene.effects.push_back(
        GroundPlane{.height = 10.0, .stiffness = 100.0 * uniform(random), .damping = uniform(random)});
  return scene;
}

/// The derivatives of all forces by positions and velocities, each over the roots of both masses.
struct Derivatives {
  Eigen::MatrixXd stiffness, damping;
};

inline Derivatives derivatives(const Scene& scene) {
  const Eigen::Index n = Eigen::Index(scene.particles.size());
  Derivatives d{Eigen::MatrixXd::Zero(3 * n, 3 * n), Eigen::MatrixXd::Zero(3 * n, 3 * n)};
  std::vector<double> root(scene.particles.size());
  for (std::size_t i = 0; i < root.size(); ++i) root[i] = 1.0 / std::sqrt(scene.particles.mass[i]);
  for (const Pin& pin : scene.pins) root[pin.particle] = 0.0;
  const auto add = [&](Eigen::MatrixXd& matrix, Index i, Index j, const Eigen::Matrix3d& block) {
    matrix.block<3, 3>(3 * i, 3 * j) += root[i] * root[j] * block;
  };
  for (std::size_t s = 0; s < scene.springs.size(); ++s) {
    const Index i = scene.springs.first[s], j = scene.springs.second[s];
    const Vec3 apart = scene.particles.position[j] - scene.particles.position[i];
    const Eigen::Matrix3d along = apart.normalized() * apart.normalized().transpose();
    const double stretch = 1.0 - scene.springs.rest_length[s] / apart.norm();
    const Eigen::Matrix3d k =
        scene.springs.stiffness[s] * (along + stretch * (Eigen::Matrix3d::Identity() - along));
    const Eigen::Matrix3d c = scene.springs.damping_of(s) * along;
    for (auto [a, b, sign] : {std::tuple(i, i, 1.0), {j, j, 1.0}, {i, j, -1.0}, {j, i, -1.0}}) {
      add(d.stiffness, a, b, sign * k);
      add(d.damping, a, b, sign * c);
    }
  }
  for (Index i = 0; i < Index(n); ++i) {
    for (const Effect& effect : scene.effects) {
      if (const auto* drag = std::get_if<Drag>(&effect))
        add(d.damping, i, i, drag->coefficient * Eigen::Matrix3d::Identity());
      if (const auto* ground = std::get_if<GroundPlane>(&effect)) {
        const Eigen::Matrix3d normal = ground->normal * ground->normal.transpose();
        add(d.stiffness, i, i, ground->stiffness * normal);
        add(d.damping, i, i, ground->damping * normal);
      }
    }
  }
  return d;
}

inline double largest_eigenvalue(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

}  // namespace hooke::test
