#include <algorithm>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/measures.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr double decay = 2.0;  // [1/s] of a particle's speed by drag

Scene make(Extent extent) {
  Sheet made = sheet(extent == Extent::whole ? 16 : 8, 0.05);
  Noise noise(7);
  for (Vec3& position : made.scene.particles.position) position = 1e-9 * noise.vector();
  made.scene.effects = {Drag{decay * made.scene.particles.mass[made.grid.at(1, 1)]}};
  return made.scene;
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    run.take(300);
    const std::vector<double> all = strains(scene, run.positions());
    judge.at_most("largest |l / l0 - 1| after 5 s", *std::max_element(all.begin(), all.end()), 0.01);
  };
  return judged(scene, asked_of(method, scene, frame), 10, drive);
}

}  // namespace

const HardCase collapsed_cloth{
    7,
    "collapsed_cloth",
    "A free cloth of 16 x 16 particles (quick: 8 x 8), all at one point but for noise of 1e-9 m, with damped "
    "springs "
    "(0.05 N s/m) and drag (speed decays with 2/s). 5 s in steps of 1/60 s.",
    "After 5 s all springs are within 1 % of their rest lengths.",
    "That it is flat again: without bend springs and contact a fold costs nothing.",
    frame,
    make,
    run,
    true};

}  // namespace hooke::hard
