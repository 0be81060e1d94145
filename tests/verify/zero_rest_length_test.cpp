// Springs without rest length make a network linear, however far it moves: its motion is a sum of modes that
// do not change. That is an exact test of how forces are put together, on any network and in every mode of
// accumulation.

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>

#include "scenes.h"
#include "verify/method_theory.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// A random network without rest lengths. What is pinned is at the origin, so that no force is constant.
Scene linear_network(std::uint32_t seed) {
  Scene scene = RandomNetwork(seed).make();
  for (double& length : scene.springs.rest_length) length = 0.0;
  scene.springs.damping.clear();
  for (const Pin& pin : scene.pins) {
    scene.particles.position[pin.particle].setZero();
    scene.particles.velocity[pin.particle].setZero();
  }
  return scene;
}

/// Some that have springs enough.
std::vector<Scene> linear_networks() {
  std::vector<Scene> networks;
  for (std::uint32_t seed = 0; networks.size() < 4; ++seed) {
    const Scene scene = linear_network(seed);
    if (scene.springs.size() > 200) networks.push_back(scene);
  }
  return networks;
}

/// The modes of a network: eigenvectors of M^-1/2 K M^-1/2, with K the Laplacian of the graph of springs,
/// weighted by stiffness, and rows and columns of pinned particles left out.
class Modes {
 public:
  using Columns = Eigen::Matrix<double, Eigen::Dynamic, 3>;

  explicit Modes(const Scene& scene) : root_mass_(Eigen::Index(scene.particles.size())) {
    const Eigen::Index count = root_mass_.size();
    Eigen::MatrixXd laplacian = Eigen::MatrixXd::Zero(count, count);
    for (std::size_t s = 0; s < scene.springs.size(); ++s) {
      const Index a = scene.springs.first[s], b = scene.springs.second[s];
      const double k = scene.springs.stiffness[s];
      laplacian(a, a) += k;
      laplacian(b, b) += k;
      laplacian(a, b) -= k;
      laplacian(b, a) -= k;
    }
    for (const Pin& pin : scene.pins) {
      laplacian.row(pin.particle).setZero();
      laplacian.col(pin.particle).setZero();
    }
    for (Eigen::Index i = 0; i < count; ++i) root_mass_[i] = std::sqrt(scene.particles.mass[std::size_t(i)]);
    const Eigen::VectorXd inverse = root_mass_.cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(inverse.asDiagonal() * laplacian *
                                                                inverse.asDiagonal());
    shapes_ = solver.eigenvectors();
    frequencies_ = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  }

  double highest() const { return frequencies_.maxCoeff(); }  ///< [1/s]

  /// Each mode's (q, p) becomes step_of(w) (q, p); returns positions.
  template <class StepOf>
  Columns moved(const Scene& scene, const StepOf& step_of) const {
    Columns q(root_mass_.size(), 3), p(root_mass_.size(), 3);
    for (Eigen::Index i = 0; i < q.rows(); ++i) {
      q.row(i) = scene.particles.position[std::size_t(i)];
      p.row(i) = scene.particles.velocity[std::size_t(i)];
    }
    q = shapes_.transpose() * root_mass_.asDiagonal() * q;
    p = shapes_.transpose() * root_mass_.asDiagonal() * p;
    for (Eigen::Index mode = 0; mode < q.rows(); ++mode) {
      const Eigen::Matrix2d map = step_of(frequencies_[mode]);
      q.row(mode) = (map(0, 0) * q.row(mode) + map(0, 1) * p.row(mode)).eval();
    }
    return root_mass_.cwiseInverse().asDiagonal() * (shapes_ * q);
  }

 private:
  Eigen::VectorXd root_mass_, frequencies_;
  Eigen::MatrixXd shapes_;
};

/// What `steps` steps do to (q, p) of a mode of frequency w: a free drift where there is no spring.
Eigen::Matrix2d power_of_step(const MethodTheory& theory, double w, double h, int steps) {
  if (w * h * steps < 1e-6) return Eigen::Matrix2d{{1.0, h * steps}, {0.0, 1.0}};
  StepMatrix power = StepMatrix::Identity();
  for (int i = 0; i < steps; ++i) power = theory.step(h * w, 0.0) * power;
  return Eigen::Matrix2d{{power(0, 0), power(0, 1) / w}, {w * power(1, 0), power(1, 1)}};
}

/// The exact motion of a mode over the time t.
Eigen::Matrix2d rotation(double w, double t) {
  if (w * t < 1e-6) return Eigen::Matrix2d{{1.0, t}, {0.0, 1.0}};
  return Eigen::Matrix2d{{std::cos(w * t), std::sin(w * t) / w}, {-w * std::sin(w * t), std::cos(w * t)}};
}

/// The largest distance of a particle from where it should be, against the largest coordinate.
double relative_error(const Simulation<double>& simulation, const Modes::Columns& exact) {
  double worst = 0.0;
  for (Eigen::Index i = 0; i < exact.rows(); ++i) {
    worst = std::max(worst, (position(simulation, Index(i)) - exact.row(i).transpose()).norm());
  }
  return worst / exact.cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("networks without rest lengths step as their modes do, in every method and mode of accumulation") {
  const int steps = 100;
  for (const MethodTheory& theory : methods()) {
    CAPTURE(theory.name());
    double worst = 0.0;
    for (const Scene& scene : linear_networks()) {
      const Modes modes(scene);
      const double h = 0.5 / modes.highest();
      const auto exact = modes.moved(scene, [&](double w) { return power_of_step(theory, w, h, steps); });
      for (auto accumulation : accumulations) {
        Simulation<double> simulation(scene,
                                      {.method = theory.method, .step = h, .accumulation = accumulation});
        REQUIRE(simulation.step(steps).ok());
        const double error = relative_error(simulation, exact);
        CHECK(error < 1e-11);
        worst = std::max(worst, error);
      }
    }
    MESSAGE(theory.name() << ": within " << worst << " of the size");
  }
}

TEST_CASE(
    "networks without rest lengths step as their modes do in implicit methods, in steps of any length") {
  for (const MethodTheory& theory : implicit_methods()) {
    CAPTURE(theory.name());
    double worst = 0.0;
    for (const Scene& scene : linear_networks()) {
      const Modes modes(scene);
      for (const double z : {0.5, 5.0, 500.0}) {
        const double h = z / modes.highest();
        const int steps = 20;
        const auto exact = modes.moved(scene, [&](double w) { return power_of_step(theory, w, h, steps); });
        Simulation<double> simulation(scene, {.method = theory.method, .step = h});
        const Report report = simulation.step(steps);
        REQUIRE(report.ok());
        CHECK(report.flags == flag_none);
        const double error = relative_error(simulation, exact);
        CHECK(error < 1e-9);
        worst = std::max(worst, error);
      }
    }
    MESSAGE(theory.name() << ": within " << worst << " of the size");
  }
}

TEST_CASE("networks without rest lengths follow their modes' exact motion") {
  for (const Method& method : {Method(RungeKutta4{}), Method(BlanesMoan{})}) {
    for (const Scene& scene : linear_networks()) {
      const Modes modes(scene);
      const double h = 0.02 / modes.highest();
      const auto exact = modes.moved(scene, [&](double w) { return rotation(w, 5000 * h); });
      Simulation<double> simulation(scene, {.method = method, .step = h});
      REQUIRE(simulation.step(5000).ok());
      const double error = relative_error(simulation, exact);
      CHECK(error < 1e-6);
      MESSAGE(to_string(method) << ", " << scene.springs.size() << " springs: within " << error
                                << " of the size");
    }
  }
}
