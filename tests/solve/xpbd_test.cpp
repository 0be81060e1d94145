#include "solve/xpbd.h"

#include <doctest/doctest.h>

#include <Eigen/Core>

#include "fine_executor.h"
#include "irregular_mesh.h"
#include "solve/hard_scenes.h"
#include "solve/solver_run.h"

using namespace hooke;
using namespace hooke::test;

namespace {

template <class Real>
using Run = SolverRun<Real, Xpbd>;

constexpr Xpbd one_by_one{.substeps = 1, .iterations = 1};

/// A particle on a spring of rest length zero to a fixed point at the origin.
Scene tethered(double mass, double stiffness, double damping, const Vec3& position, const Vec3& velocity) {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  scene.add_particle(mass, position, velocity);
  scene.add_spring(0, 1, stiffness, 0.0, damping);
  scene.pin(0);
  return scene;
}

}  // namespace

TEST_CASE("one iteration on one linear spring is a step of backward Euler") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int trial = 0; trial < 100; ++trial) {
    const double mass = std::exp2(4.0 * unit(random)), k = std::exp(10.0 * unit(random)), h = 0.1;
    Vec3 x(unit(random), unit(random), unit(random)), v(unit(random), unit(random), unit(random));
    Run<double> run(tethered(mass, k, 0.0, x, v), one_by_one);
    for (int step = 0; step < 5; ++step) {
      run.step(h);
      const Vec3 after = (x + h * v) / (1.0 + h * h * k / mass);
      v = (after - x) / h;
      x = after;
      CHECK((run.position(1) - x).norm() <= 1e-12 * x.norm());
      CHECK((run.velocity(1) - v).norm() <= 1e-11 * v.norm());
    }
  }
}

TEST_CASE("a damped one is too, along a line") {
  const double mass = 0.5, k = 300.0, c = 7.0, h = 0.02;
  double x = 0.3, v = -1.0;
  Run<double> run(tethered(mass, k, c, {x, 0, 0}, {v, 0, 0}), one_by_one);
  for (int step = 0; step < 20; ++step) {
    run.step(h);
    v = (mass * v - h * k * x) / (mass + h * h * k + h * c);
    x += h * v;
    CHECK(run.position(1).x() == doctest::Approx(x).epsilon(1e-10));
  }
}

TEST_CASE("a damper alone, of a spring without stiffness, slows its ends and keeps their momentum") {
  Scene scene;
  scene.add_particle(1.0, Vec3(0, 0, 0), Vec3(1, 0, 0));
  scene.add_particle(3.0, Vec3(1, 0, 0), Vec3(-1, 0, 0));
  scene.add_spring(0, 1, 0.0, 1.0, 2.0);
  Run<double> run(scene, one_by_one);
  const double h = 0.1, reduced = 0.75;
  run.step(h);
  CHECK((run.velocity(0) - run.velocity(1)).x() == doctest::Approx(2.0 / (1.0 + h * 2.0 / reduced)));
  CHECK((run.velocity(0) + 3.0 * run.velocity(1)).x() == doctest::Approx(-2.0));
}

TEST_CASE("substeps are steps") {
  const Scene scene = disturbed_cloth(1.0, 0.2, 0.01);
  Run<double> whole(scene, Xpbd{.substeps = 8}), parts(scene, one_by_one);
  for (int step = 0; step < 10; ++step) whole.step(1.0 / 64.0);
  for (int step = 0; step < 80; ++step) parts.step(1.0 / 512.0);
  CHECK(same_bits(whole.now, parts.now));
}

TEST_CASE("pins go along a straight line within a step") {
  Scene scene = tethered(1.0, 1e6, 0.0, {0, -1, 0}, Vec3::Zero());
  scene.springs.rest_length[0] = 1.0;
  const Vec3 to(2, 0, 0);
  scene.pins[0].path = {{0.0, Vec3::Zero()}, {0.5, to}};
  Simulation<double> whole(scene, {.method = Xpbd{.substeps = 50}, .step = 0.5});
  Simulation<double> parts(scene, {.method = one_by_one, .step = 0.01});
  REQUIRE(whole.step().ok());
  REQUIRE(parts.step(50).ok());
  CHECK(position(whole, 0) == to);
  CHECK((position(whole, 1) - position(parts, 1)).norm() < 1e-9);
}

TEST_CASE("momentum of a free network is kept") {
  Scene scene = disturbed_cloth(0.7, 0.4, 0.02);
  scene.pins.clear();
  scene.effects.clear();
  Run<double> run(scene, Xpbd{});
  const auto momentum = [&] {
    Vec3 sum = Vec3::Zero();
    for (Index i = 0; i < scene.particles.size(); ++i) sum += scene.particles.mass[i] * run.velocity(i);
    return sum;
  };
  const Vec3 before = momentum();
  for (int step = 0; step < 20; ++step) run.step(1.0 / 60.0);
  CHECK((momentum() - before).norm() < 1e-12);
}

TEST_CASE("a stiff ground in a long step stops what falls on it, and nothing explodes") {
  Scene scene;
  scene.add_particle(1e-3, Vec3(0, 1, 0), Vec3(0, -100, 0));
  scene.add_particle(1e-3, Vec3(0.1, 1, 0), Vec3(0, -100, 0));
  scene.add_spring(0, 1, 1e4, 0.1);
  scene.effects = {Gravity{}, GroundPlane{.stiffness = 1e8, .damping = 1e3}, Drag{1.0}};
  Run<double> run(scene, Xpbd{.substeps = 2});
  for (int step = 0; step < 100; ++step) {
    run.step(1.0 / 30.0);
    CHECK(run.position(0).y() > -1e-3);
    CHECK(run.position(0).y() < 1.1);
  }
}

TEST_CASE_TEMPLATE("nothing degenerate makes values that are not finite in XPBD", Real, float, double) {
  for (const auto& [what, scene] : degenerate_scenes()) {
    for (const std::uint64_t iterations : {1, 4}) {
      CAPTURE(what);
      Run<Real> run(scene, Xpbd{.substeps = 5, .iterations = iterations});
      const State<Real> before = run.now;
      for (int step = 0; step < 20; ++step) run.step(1.0 / 60.0);
      CHECK(run.finite());
      for (std::size_t i = 0; i < run.now.size(); ++i) {
        if (run.model.pinned(i)) CHECK(run.now.position(i) == before.position(i));
      }
    }
  }
}

TEST_CASE("free particles keep their velocity exactly, beside springs") {
  Scene scene = tethered(1.0, 100.0, 0.0, {1, 0, 0}, {0, 1, 0});
  scene.add_particle(0.3, Vec3(0.1, 0.2, 0.3), Vec3(0.7, -0.3, 0.1));
  Run<float> run(scene, Xpbd{});
  const Vec3 before = run.velocity(2);
  for (int step = 0; step < 100; ++step) run.step(1.0 / 60.0);
  CHECK(run.velocity(2) == before);
}

namespace {

/// The chain of Macklin, Mueller and Chentanez 2016: 20 particles of 1 kg, the first one fixed, compliance
/// 1e-8 m/N. It begins level, and swings down.
struct Chain {
  static constexpr Index particles = 20;
  static constexpr double mass = 1.0, stiffness = 1e8, length = 0.1, g = 9.81, h = 0.01;

  static Scene scene() {
    Scene scene;
    for (Index i = 0; i < particles; ++i) scene.add_particle(mass, Vec3(length * i, 0, 0));
    for (Index i = 1; i < particles; ++i) scene.add_spring(i - 1, i, stiffness, length);
    scene.pin(0);
    scene.effects = {Gravity{Vec3(0, -g, 0)}};
    return scene;
  }
};

/// The force of the top spring in each frame. It is known from outside: what the chain's momentum grows by,
/// less its weight.
template <class Runner>
Eigen::ArrayXd top_forces(Runner& run, int frames) {
  Eigen::ArrayXd forces(frames);
  Vec3 momentum = Vec3::Zero();
  for (int frame = 0; frame < frames; ++frame) {
    run.step(Chain::h);
    Vec3 after = Vec3::Zero();
    for (Index i = 1; i < Chain::particles; ++i) after += Chain::mass * run.velocity(i);
    const Vec3 weight(0, -Chain::g * Chain::mass * (Chain::particles - 1), 0);
    forces[frame] = ((after - momentum) / Chain::h - weight).norm();
    momentum = after;
  }
  return forces;
}

}  // namespace

TEST_CASE("the force at the top of a heavy chain comes near Newton's with iterations, as published") {
  const Scene scene = Chain::scene();
  SolverRun<double, Method> newton(scene, BackwardEuler{.tolerance = 1e-12, .most_iterations = 500});
  const Eigen::ArrayXd exact = top_forces(newton, 100);
  struct Row {
    std::uint64_t iterations;
    double most;
  };
  for (const Row row : {Row{50, 0.06}, Row{100, 0.02}, Row{1000, 0.005}}) {
    Run<double> run(scene, Xpbd{.substeps = 1, .iterations = row.iterations});
    const Eigen::ArrayXd error = top_forces(run, 100) - exact;
    const double rms = std::sqrt(error.square().sum() / exact.square().sum());
    MESSAGE(row.iterations, " iterations: error ", 100.0 * rms,
            " % of the force, RMS over 100 frames; at most ",
            100.0 * error.abs().maxCoeff() / exact.maxCoeff(), " % of the largest force");
    CHECK(rms < row.most);
  }
}

namespace {

/// How far XPBD and backward Euler are apart after a step, as a share of the motion, RMS.
double gap_to_backward_euler(const Scene& scene, double h, std::uint64_t iterations) {
  SolverRun<double, Method> newton(scene, BackwardEuler{.tolerance = 1e-12});
  Run<double> run(scene, Xpbd{.substeps = 1, .iterations = iterations});
  newton.step(h);
  run.step(h);
  double square = 0.0, moved = 0.0;
  for (Index i = 0; i < scene.particles.size(); ++i) {
    square += (run.position(i) - newton.position(i)).squaredNorm();
    moved += (newton.position(i) - scene.particles.position[i]).squaredNorm();
  }
  return std::sqrt(square / moved);
}

}  // namespace

TEST_CASE(
    "XPBD comes near backward Euler with the same steps; shorter steps close the gap, iterations do not") {
  const Scene scene = disturbed_cloth(1.0, 0.1);
  const auto gap = [&](double h, std::uint64_t iterations) {
    const double share = gap_to_backward_euler(scene, h, iterations);
    MESSAGE("step of ", h, " s, ", iterations, " iterations: RMS gap ", 100.0 * share, " % of the motion");
    return share;
  };
  const double h = 1.0 / 240.0, first = gap(h, 1), some = gap(h, 10), many = gap(h, 1000);
  CHECK(first < 0.5);
  CHECK(some < 0.2 * first);
  CHECK(many == doctest::Approx(some).epsilon(0.05));
  CHECK(gap(h / 4.0, 1000) < 0.5 * many);
}
