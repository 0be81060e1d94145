// The solvers of other projects, on the engine's own forces, against closed forms: this is what makes them
// references.

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>
#include <set>

#include "reference_scenes.h"

using namespace hooke;
using namespace hooke::reference;
using namespace hooke::test;

namespace {

std::vector<double> solved(const Solver& solver, const Scene& scene, double end) {
  EngineForces forces(scene);
  return solution(solver, forces, forces.start(), end, {});
}

/// A network of springs of no rest length is linear: M x'' = -K x + f, the same along each axis, where f is
/// the pull of the pins. So each mode swings by itself about the state of rest.
struct Modes {
  Eigen::MatrixXd stiffness;  ///< K [N/m] between free particles
  Eigen::MatrixX3d pull;      ///< f [N]
  Eigen::VectorXd root_mass;
  std::vector<Index> free;

  explicit Modes(const Scene& scene) {
    std::vector<Eigen::Index> row(scene.particles.size(), 0);
    for (const Pin& pin : scene.pins) row[pin.particle] = -1;
    for (Index i = 0; i < row.size(); ++i) {
      if (row[i] == 0) {
        row[i] = Eigen::Index(free.size());
        free.push_back(i);
      }
    }
    const auto n = Eigen::Index(free.size());
    stiffness = Eigen::MatrixXd::Zero(n, n);
    pull = Eigen::MatrixX3d::Zero(n, 3);
    root_mass.resize(n);
    for (Index i : free) root_mass[row[i]] = std::sqrt(scene.particles.mass[i]);
    for (std::size_t s = 0; s < scene.springs.size(); ++s) {
      const Index ends[] = {scene.springs.first[s], scene.springs.second[s]};
      for (int end : {0, 1}) {
        const Index a = ends[end], b = ends[1 - end];
        if (row[a] < 0) continue;
        const double k = scene.springs.stiffness[s];
        stiffness(row[a], row[a]) += k;
        if (row[b] >= 0)
          stiffness(row[a], row[b]) -= k;
        else
          pull.row(row[a]) += k * scene.particles.position[b].transpose();
      }
    }
  }

  /// Positions [m] at `time` [s] of the free particles.
  Eigen::MatrixX3d positions(const Scene& scene, double time) const {
    const auto n = Eigen::Index(free.size());
    Eigen::MatrixX3d x(n, 3), v(n, 3);
    for (Eigen::Index i = 0; i < n; ++i) {
      x.row(i) = scene.particles.position[free[std::size_t(i)]].transpose();
      v.row(i) = scene.particles.velocity[free[std::size_t(i)]].transpose();
    }
    const Eigen::VectorXd inverse_root = root_mass.cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(inverse_root.asDiagonal() * stiffness *
                                                               inverse_root.asDiagonal());
    const Eigen::MatrixX3d rest = stiffness.partialPivLu().solve(pull);
    const Eigen::ArrayXd w = modes.eigenvalues().array().sqrt();
    const Eigen::MatrixXd to_modes = modes.eigenvectors().transpose() * root_mass.asDiagonal();
    const Eigen::MatrixX3d from = to_modes * (x - rest), speed = to_modes * v;
    const Eigen::VectorXd cosine = (w * time).cos(), sine = (w * time).sin() / w;
    const Eigen::MatrixX3d now = cosine.asDiagonal() * from + sine.asDiagonal() * speed;
    return rest + inverse_root.asDiagonal() * (modes.eigenvectors() * now);
  }
};

}  // namespace

TEST_CASE("solvers: a network of zero rest lengths is the sum of its modes") {
  const ReferenceScene network = linear_network();
  const Eigen::MatrixX3d exact = Modes(network.scene).positions(network.scene, network.end);
  for (const Solver& solver : solvers()) {
    const std::vector<double> y = solved(solver, network.scene, network.end);
    double worst = 0.0;
    for (Eigen::Index i = 0; i < exact.rows(); ++i)
      worst = std::max(worst, (Vec3(y.data() + 3 * i) - exact.row(i).transpose()).norm());

    CHECK_MESSAGE(worst < 1e-10, solver.name);
  }
}

TEST_CASE("solvers: an oscillator with drag, in gravity, driven off its own frequency") {
  // x'' + 2 d x' + w^2 x = F cos(W t) / m along x, and the weight's stretch along y.
  const double mass = 0.7, k = 90.0, c = 0.4, force = 3.0, drive = 5.0, end = 3.0, g = 9.81;
  const double w2 = k / mass, d = 0.5 * c / mass, wd = std::sqrt(w2 - d * d);
  Scene scene;
  scene.pin(scene.add_particle(1.0, Vec3::Zero()));
  scene.add_particle(mass, {0.0, -0.1, 0.2});
  scene.add_spring(0, 1, k, 0.0);
  scene.effects = {Gravity{}, Drag{c}, Field{[&](const Vec3&, double t) -> Vec3 {
                     return {force * std::cos(drive * t), 0.0, 0.0};
                   }}};
  const auto free_swing = [&](double x0, double v0) {
    return std::exp(-d * end) * (x0 * std::cos(wd * end) + (v0 + d * x0) / wd * std::sin(wd * end));
  };
  // The steady answer is a cos(W t) + b sin(W t).
  const double lag = 2.0 * d * drive, off = w2 - drive * drive, size = force / mass / (off * off + lag * lag);
  const double a = size * off, b = size * lag, sag = -mass * g / k;
  const Vec3 exact(free_swing(-a, -drive * b) + a * std::cos(drive * end) + b * std::sin(drive * end),
                   sag + free_swing(-0.1 - sag, 0.0), free_swing(0.2, 0.0));
  for (const Solver& solver : solvers()) {
    const std::vector<double> y = solved(solver, scene, end);
    const double error = (Vec3(y.data()) - exact).norm();

    CHECK_MESSAGE(error < 1e-11, solver.name);
  }
}

TEST_CASE("solvers: a throw in gravity and drag") {
  const double mass = 0.3, c = 0.5, end = 2.0, rate = c / mass;
  const Vec3 start(1, 2, 3), speed(4, 5, -6), fall = Vec3(0, -9.81, 0) / rate;
  Scene scene;
  scene.add_particle(mass, start, speed);
  scene.effects = {Gravity{}, Drag{c}};
  const Vec3 exact = start + fall * end + (speed - fall) * (1.0 - std::exp(-rate * end)) / rate;
  for (const Solver& solver : solvers()) {
    const std::vector<double> y = solved(solver, scene, end);
    CHECK_MESSAGE((Vec3(y.data()) - exact).norm() < 1e-11 * exact.norm(), solver.name);
  }
}

TEST_CASE("solvers: they ask for the engine's forces, and say how often") {
  const ReferenceScene cloth = taut_cloth();
  for (const Solver& solver : solvers()) {
    EngineForces forces(cloth.scene);
    const std::vector<double> y = solution(solver, forces, forces.start(), 0.1, cloth.scale);
    CHECK(y.size() == 6 * 64);
    CHECK(forces.calls() > 10);
  }
}
