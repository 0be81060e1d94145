#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>

#include "kernels/gather_derivative.h"
#include "methods/evaluate.h"
#include "scenes.h"
#include "solve/particle_blocks.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// A random network without pins, and a state of it in which springs are stretched and pressed. Both ends of
/// some springs are at one place in these networks: there the derivative has no limit, so they are moved.
struct Network {
  Scene scene;
  std::shared_ptr<Executor> executor = make_tbb_executor(1);
  Model<double> model;
  Forces<double> forces;
  State<double> state;

  explicit Network(std::uint32_t seed)
      : scene(make(seed)),
        model(scene, Accumulation::gather, *executor),
        forces(scene, model),
        state(initial_state(scene, model)) {}

  bool has_springs() const { return slots_of(model) != nullptr; }
  Eigen::Index unknowns() const { return 3 * Eigen::Index(model.particles()); }

  /// Forces where the particles are moved by `share` of p.
  Eigen::VectorXd forces_at(double share, const Eigen::VectorXd& p) {
    State<double> moved = state;
    for (std::size_t i = 0; i < model.particles(); ++i)
      moved.set_position(i, state.position(i) + share * p.segment<3>(3 * Eigen::Index(i)));
    Accelerations<double> accelerations(model.particles(), 1);
    evaluate(moved, model, forces, *executor, accelerations, 0);
    Eigen::VectorXd result(unknowns());
    for (std::size_t i = 0; i < model.particles(); ++i)
      result.segment<3>(3 * Eigen::Index(i)) = accelerations.vector(0, i) / model.inverse_mass[i];
    return result;
  }

  Eigen::VectorXd product(const Eigen::VectorXd& p, const DerivativeWeights<double>& weights,
                          PressedSprings pressed) const {
    const State<double> search = with_direction(p);
    Eigen::VectorXd result(unknowns());
    StripForce<double> out;
    for_each_strip(0, block_count(model.particles()), [&](std::size_t begin, std::size_t end) {
      gather_product(*slots_of(model), search, begin, end, weights, pressed, out);
      for (std::size_t i = begin * block_size; i < std::min(end * block_size, model.particles()); ++i) {
        const std::size_t lane = i - begin * block_size;
        result.segment<3>(3 * Eigen::Index(i)) = Vec3(out.x[lane], out.y[lane], out.z[lane]);
      }
    });
    return result;
  }

  Eigen::MatrixXd matrix(const DerivativeWeights<double>& weights, PressedSprings pressed) const {
    Eigen::MatrixXd result(unknowns(), unknowns());
    for (Eigen::Index i = 0; i < unknowns(); ++i)
      result.col(i) = product(Eigen::VectorXd::Unit(unknowns(), i), weights, pressed);
    return result;
  }

  State<double> with_direction(const Eigen::VectorXd& p) const {
    State<double> search(model.particles(), Packed::positions_and_velocities);
    for (std::size_t i = 0; i < model.particles(); ++i) {
      search.set_position(i, state.position(i));
      search.set_velocity(i, p.segment<3>(3 * Eigen::Index(i)));
    }
    return search;
  }

 private:
  static Scene make(std::uint32_t seed) {
    Scene scene = RandomNetwork(seed).make();
    scene.pins.clear();
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (Vec3& x : scene.particles.position) x = {any(random), any(random), any(random)};
    for (Vec3& v : scene.particles.velocity) v.setZero();
    return scene;
  }
};

Eigen::VectorXd random_direction(Eigen::Index size, std::uint32_t seed) {
  std::srand(seed);
  return Eigen::VectorXd::Random(size);
}

constexpr DerivativeWeights<double> of_stiffness{1.0, 0.0}, of_both{0.3, 0.7};

}  // namespace

TEST_CASE("the product with the force derivative meets central differences to 1e-6, stretched and pressed") {
  double worst = 0.0;
  unsigned networks = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    Network network(seed);
    if (!network.has_springs()) continue;
    ++networks;
    const Eigen::VectorXd p = random_direction(network.unknowns(), seed);
    const double share = 1e-6;
    const Eigen::VectorXd expected =
        (network.forces_at(-share, p) - network.forces_at(share, p)) / (2.0 * share);
    const Eigen::VectorXd found = network.product(p, of_stiffness, PressedSprings::exact);
    const double error = (found - expected).norm() / expected.norm();
    CHECK(error < 1e-6);
    worst = std::max(worst, error);
  }
  CHECK(networks > 40);
  MESSAGE("largest relative difference: " << worst);
}

TEST_CASE("the derivative is symmetric, its diagonal is what is said, and without push never negative") {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const Network network(seed);
    if (!network.has_springs() || network.unknowns() > 300) continue;
    CAPTURE(seed);
    for (const auto pressed : {PressedSprings::exact, PressedSprings::no_push}) {
      const Eigen::MatrixXd k = network.matrix(of_both, pressed);
      CHECK((k - k.transpose()).cwiseAbs().maxCoeff() < 1e-13 * k.cwiseAbs().maxCoeff());
      StripBlocks<double> blocks;
      const State<double> search = network.with_direction(Eigen::VectorXd::Zero(network.unknowns()));
      const std::size_t count = std::min<std::size_t>(network.model.particles(), block_size);
      gather_diagonal(*slots_of(network.model), search, 0, 1, of_both, pressed, blocks);
      for (std::size_t i = 0; i < count; ++i) {
        const Eigen::Matrix3d expected = k.block<3, 3>(3 * Eigen::Index(i), 3 * Eigen::Index(i));
        const Eigen::Matrix3d found{{blocks.xx[i], blocks.xy[i], blocks.xz[i]},
                                    {blocks.xy[i], blocks.yy[i], blocks.yz[i]},
                                    {blocks.xz[i], blocks.yz[i], blocks.zz[i]}};
        CHECK((found - expected).cwiseAbs().maxCoeff() < 1e-12 * k.cwiseAbs().maxCoeff());
      }
      if (pressed == PressedSprings::no_push) {
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(k, Eigen::EigenvaluesOnly);
        CHECK(solver.eigenvalues().minCoeff() > -1e-11 * solver.eigenvalues().maxCoeff());
      }
    }
  }
}

TEST_CASE_TEMPLATE("where both ends of a spring are at one place the derivative is finite", Real, float,
                   double) {
  Scene scene;
  scene.add_particle(1.0, {1, 2, 3});
  scene.add_particle(1.0, {1, 2, 3});
  scene.add_spring(0, 1, 1e6, 1.0, 10.0);
  const auto executor = make_tbb_executor(1);
  const Model<Real> model(scene, Accumulation::gather, *executor);
  State<Real> search(2, Packed::positions_and_velocities);
  for (std::size_t i = 0; i < 2; ++i) search.set_position(i, {Real(1), Real(2), Real(3)});
  search.set_velocity(0, {Real(1), Real(1), Real(1)});
  StripForce<Real> product;
  StripBlocks<Real> blocks;
  gather_product(*slots_of(model), search, 0, 1, {Real(1), Real(1)}, PressedSprings::no_push, product);
  gather_diagonal(*slots_of(model), search, 0, 1, {Real(1), Real(1)}, PressedSprings::no_push, blocks);
  CHECK(product.x[0] == Real(0));
  CHECK(blocks.xx[0] == Real(0));
  CHECK(blocks.yz[1] == Real(0));
}

TEST_CASE("the inverse of a symmetric matrix of three rows, also one that rounding makes singular") {
  std::mt19937 random(1);
  std::normal_distribution<double> any;
  for (int i = 0; i < 1000; ++i) {
    Eigen::Matrix3d a;
    for (double& value : a.reshaped()) value = any(random);
    const Eigen::Matrix3d m = a * a.transpose() + 1e-3 * Eigen::Matrix3d::Identity();
    const Symmetric3<double> w =
        Symmetric3<double>{m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)}.inverse();
    const Eigen::Matrix3d inverse{{w.xx, w.xy, w.xz}, {w.xy, w.yy, w.yz}, {w.xz, w.yz, w.zz}};
    CHECK((inverse * m - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-10);
  }
  // One stiff spring along (1, 1, 1) and a mass too small for float to add to it.
  const Symmetric3<float> stiff = Symmetric3<float>{1e9f, 1e9f, 1e9f, 1e9f, 1e9f, 1e9f}.inverse();
  CHECK(stiff.xx > 0.0f);
  CHECK(stiff.yy > 0.0f);
  CHECK(stiff.zz > 0.0f);
  CHECK(std::isfinite(stiff.xx + stiff.xy + stiff.xz + stiff.yy + stiff.yz + stiff.zz));
}
