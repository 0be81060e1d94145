#include <doctest/doctest.h>

#include <cmath>

#include <Eigen/Eigenvalues>

#include <hooke/hooke.h>

#include "effects/forces_of_scene.h"
#include "irregular_mesh.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// From all eigenvalues of the matrix of derivatives by finite differences of all forces.
double highest_frequency_of(const Scene& scene) {
  ForcesOfScene forces(scene);
  const Eigen::Index size = forces.positions().size();
  Eigen::VectorXd roots(size);
  for (Eigen::Index i = 0; i < size; ++i)
    roots[i] = std::sqrt(forces.model().inverse_mass[std::size_t(i / 3)]);
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i)
    matrix.col(i) = product_from_forces(forces, Eigen::VectorXd::Unit(size, i), 1e-7);
  const Eigen::MatrixXd scaled =
      roots.asDiagonal() * (0.5 * (matrix + matrix.transpose())) * roots.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled, Eigen::EigenvaluesOnly);
  return std::sqrt(solver.eigenvalues().maxCoeff());
}

template <class Real>
void check_frequency(const Scene& scene) {
  const double exact = highest_frequency_of(scene);
  const Stability stability = Simulation<Real>(scene).stability();
  CHECK(stability.frequency > 0.97 * exact);
  CHECK(stability.frequency < 1.001 * exact);
  CHECK(stability.frequency_at_most > 0.999 * exact);
  CHECK(stability.frequency_bound > exact);
}

}  // namespace

TEST_CASE_TEMPLATE("The highest frequency counts hinges, folded as they are", Real, float, double) {
  Scene scene;
  ClothMesh mesh = irregular_mesh(7);
  mesh.stretch = 1.0;
  add(scene, mesh);
  scene.pin(3);
  scene.effects = {HingeBending{.stiffness = 0.1}};
  check_frequency<Real>(scene);
}

TEST_CASE_TEMPLATE("The highest frequency counts Laplacian bending", Real, float, double) {
  Scene scene;
  const RopeParticles rope = add(scene, Rope{.particles = 40, .stretch = 10.0});
  scene.pin(0);
  scene.effects = {bending_of(rope, 1.0 / 39.0, 1e-3)};
  check_frequency<Real>(scene);
}
