#include <algorithm>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/measures.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr Index side = 9;

/// Stretched to three times its size and pinned everywhere but in the middle, which is off its place.
Scene make(Extent) {
  Sheet made = sheet(side);
  for (Vec3& position : made.scene.particles.position) position *= 3.0;
  const Index middle = made.grid.at(side / 2, side / 2);
  for (Index i = 0; i < made.scene.particles.size(); ++i) {
    if (i != middle) made.scene.pin(i);
  }
  made.scene.particles.position[middle] += Vec3(0.1, 0.05, 0.02);
  made.scene.effects = {Drag{20.0 * made.scene.particles.mass[middle]}};
  return made.scene;
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    const double at_first = largest_force(scene, scene.particles.position);
    run.take(180);
    judge.at_most("force on the free particle at the end, as a share of that at the start",
                  largest_force(scene, run.positions()) / at_first, 1e-6);
    judge.flag("springs between pins stay stretched by up to " +
               std::to_string(100.0 * run.simulation().max_strain()) + " %");
  };
  return judged(scene, asked_of(method, scene, frame), 60, drive);
}

}  // namespace

const HardCase over_constrained{
    20,
    "over_constrained",
    "A cloth of 9 x 9 particles stretched to three times its size and pinned everywhere but in the middle, "
    "which is "
    "off its place by 11 cm, with drag (its speed decays with 20/s). 3 s in steps of 1/60 s.",
    "The steps end, and the free particle comes to rest: the force on it is below 1e-6 of that at the start. "
    "How far "
    "springs between pins stay stretched is told.",
    "That a strain limiter ends where pins are further apart than it allows: there is none yet.",
    frame,
    make,
    run};

}  // namespace hooke::hard
