#include <algorithm>
#include <cmath>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/measures.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr double decay = 3.0;  // [1/s] of a particle's speed by drag

Index side(Extent extent) {
  return extent == Extent::whole ? 16 : 8;
}

/// Two opposite edges are held at half of their distance, and noise of 1e-4 m breaks the plane.
Scene make(Extent extent) {
  Sheet made = sheet(side(extent), 0.02);
  Noise noise(6);
  for (Vec3& position : made.scene.particles.position) {
    position.x() *= 0.5;
    position.z() = 1e-4 * noise.unit();
  }
  for (Index row = 0; row < made.grid.rows; ++row) {
    made.scene.pin(made.grid.at(0, row));
    made.scene.pin(made.grid.at(made.grid.columns - 1, row));
  }
  made.scene.effects = {Drag{decay * made.scene.particles.mass[made.grid.at(1, 1)]}};
  return made.scene;
}

/// How far the cloth reaches out of its plane [m].
double height(const std::vector<Vec3>& positions) {
  double most = 0.0;
  for (const Vec3& position : positions) most = std::max(most, std::abs(position.z()));
  return most;
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    const double at_first = largest_force(scene, scene.particles.position);
    run.take(extent == Extent::whole ? 1200 : 600);
    judge.at_most("largest force at the end, as a share of the largest at the start",
                  largest_force(scene, run.positions()) / at_first, 1e-6);
    judge.at_least("how far it reaches out of its plane [m]", height(run.positions()), 0.01);
  };
  return judged(scene, asked_of(method, scene, frame), 10, drive);
}

}  // namespace

const HardCase compressed_cloth{
    6,
    "compressed_cloth",
    "A cloth of 16 x 16 particles (quick: 8 x 8) without bend springs, pressed to half of its width between "
    "two held "
    "edges, with noise of 1e-4 m across its plane, damped springs (0.02 N s/m) and drag (speed decays with "
    "3/s). 20 s "
    "(quick: 10 s) in steps of 1/60 s.",
    "It buckles, by at least 1 cm, and comes to rest: no force is above 1e-6 of the largest at the start.",
    "",
    frame,
    make,
    run};

}  // namespace hooke::hard
