#include <cmath>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr int links = 10;
constexpr double mass = 0.01;        // [kg]
constexpr double rest_length = 0.1;  // [m]
constexpr double gravity = 9.81;     // [m/s^2]
constexpr double decay = 4.0;        // [1/s] of speed by drag, so that it comes to rest
constexpr int seconds = 16;

double stiffness(int link) {
  return link % 2 == 0 ? 1.0 : 1e6;
}

Scene make(Extent) {
  Scene scene;
  scene.add_particle(mass, Vec3::Zero());
  for (Index i = 0; i < links; ++i) {
    scene.add_particle(mass, {0.0, -rest_length * (i + 1.0), 0.0});
    scene.add_spring(i, i + 1, stiffness(int(i)), rest_length);
  }
  scene.pin(0);
  scene.effects = {Gravity{{0.0, -gravity, 0.0}}, Drag{decay * mass}};
  return scene;
}

/// The largest error of a spring's pull, as a share of what it carries: spring i, from 0 at the top, carries
/// the (N - i) masses below it.
double error_of_pulls(const std::vector<Vec3>& positions) {
  double worst = 0.0;
  for (int i = 0; i < links; ++i) {
    const double length = (positions[std::size_t(i) + 1] - positions[std::size_t(i)]).norm();
    const double carried = (links - i) * mass * gravity;
    worst = std::max(worst, std::abs(stiffness(i) * (length - rest_length) / carried - 1.0));
  }
  return worst;
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const auto drive = [](WatchedRun<double>& run, Judge& judge) {
    run.take(60 * seconds);
    judge.at_most("error of a spring's elongation, as a share of it", error_of_pulls(run.positions()), 1e-6);
  };
  return judged(scene, asked_of(method, scene, frame), 30, drive);
}

}  // namespace

const HardCase stiffness_ratio{
    4,
    "stiffness_ratio",
    "A chain of 10 springs, 1 N/m and 1e6 N/m by turns, and 10 masses of 0.01 kg, let go at its rest length "
    "of 1 m "
    "under gravity, with drag (speed decays with 4/s). 16 s in steps of 1/60 s.",
    "Each spring's elongation is (N - i + 1) m g / k, to 1e-6 of it: of those of 1e6 N/m that is 1e-13 m.",
    "",
    frame,
    make,
    run};

}  // namespace hooke::hard
