#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>

#include "differential/serial_reference.h"
#include "fine_executor.h"
#include "instruction_sets.h"
#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// Positions and velocities rounded to Real, as the engine holds them.
template <class Real>
Scene rounded(Scene scene) {
  scene.particles.velocity.resize(scene.particles.size(), Vec3::Zero());
  for (Vec3& x : scene.particles.position) x = x.cast<Real>().template cast<double>();
  for (Vec3& v : scene.particles.velocity) v = v.cast<Real>().template cast<double>();
  for (const Pin& pin : scene.pins) scene.particles.velocity[pin.particle].setZero();
  return scene;
}

/// The largest error of the engine's forces in units of round-off: from the change of velocity in one step of
/// 1 s.
template <class Real>
double worst_error(const Scene& scene, Accumulation accumulation, const std::shared_ptr<Executor>& executor) {
  const SerialReference reference(scene, scene.particles.position, scene.particles.velocity);
  Simulation<Real> simulation(
      scene,
      {.step = 1.0, .unstable_step = UnstableStep::take, .accumulation = accumulation, .executor = executor});
  REQUIRE(simulation.step().ok());
  std::set<Index> pinned;
  for (const Pin& pin : scene.pins) pinned.insert(pin.particle);
  double worst = 0.0;
  for (Index i = 0; i < scene.particles.size(); ++i) {
    const Vec3 change = velocity(simulation, i) - scene.particles.velocity[i];
    if (pinned.count(i) > 0) {
      CHECK(change.isZero(0.0));
      continue;
    }
    const Vec3 force = scene.particles.mass[i] * change;
    const double scale = reference.force_scale[i] + scene.particles.mass[i] * velocity(simulation, i).norm();
    if (scale == 0.0) {
      CHECK(force.isZero(0.0));
      continue;
    }
    worst = std::max(worst, (force - reference.force[i]).norm() / scale);
  }
  return worst / double(std::numeric_limits<Real>::epsilon());
}

}  // namespace

TEST_CASE_TEMPLATE(
    "gather, coloured and atomic agree with a serial loop on 100 random networks, on each "
    "instruction set",
    Real, float, double) {
  double worst = 0.0;
  std::size_t springs = 0, damped = 0, pins = 0;
  const std::shared_ptr<Executor> one_thread = make_tbb_executor(1), fine = std::make_shared<FineExecutor>(3);
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const Scene scene = rounded<Real>(RandomNetwork(seed).make());
    springs += scene.springs.size();
    damped += scene.springs.damping.empty() ? 0 : 1;
    pins += scene.pins.size();
    on_each_instruction_set([&] {
      for (auto accumulation : accumulations) {
        for (const auto& executor : {one_thread, fine}) {
          worst = std::max(worst, worst_error<Real>(scene, accumulation, executor));
        }
      }
    });
  }
  MESSAGE("largest error: ", worst, " units of round-off of the forces");
  // A few roundings in each term.
  CHECK(worst < 8.0);
  // The networks are not trivial.
  CHECK(springs > 10'000);
  CHECK(damped > 20);
  CHECK(pins > 100);
}

TEST_CASE_TEMPLATE("a hub with more springs than colours", Real, float, double) {
  Scene star;
  star.add_particle(1.0, {0, 0, 0});
  for (int i = 1; i <= 5000; ++i) {
    star.add_particle(1.0, {std::cos(i), std::sin(i), 0.001 * i});
    star.add_spring(0, Index(i), 10.0, 0.5);
  }
  const Scene scene = rounded<Real>(star);
  const auto fine = std::make_shared<FineExecutor>(4);
  for (auto accumulation : accumulations) {
    // One rounding for each of the hub's terms, in the worst case; a lost addition is 1e3 times as much.
    CHECK(worst_error<Real>(scene, accumulation, fine) < 100.0);
  }
}

TEST_CASE("the reference itself: two particles on a stretched, damped spring") {
  Scene scene;
  scene.add_particle(1.0, {0, 0, 0}, {1, 0, 0});
  scene.add_particle(1.0, {0, 3, 4}, {0, 0, 5});
  scene.add_spring(0, 1, 10.0, 2.0, 0.5);
  const SerialReference reference(scene, scene.particles.position, scene.particles.velocity);
  const Vec3 expected = (10.0 * 3.0 + 0.5 * 4.0) * Vec3(0, 0.6, 0.8);
  CHECK(reference.force[0].isApprox(expected));
  CHECK(reference.force[1].isApprox(-expected));
}
