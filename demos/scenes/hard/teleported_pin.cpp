#include <algorithm>
#include <string>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/measures.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr double decay = 4.0;    // [1/s] of a particle's speed by drag
constexpr double away = 577.35;  // [m] along each axis: 1000 m

Sheet made(Extent extent) {
  Sheet made = hung_sheet(extent == Extent::whole ? 16 : 8, 0.05);
  Noise noise(12);  // in a plane, what is folded could not unfold
  for (Vec3& position : made.scene.particles.position) position.z() = 1e-3 * noise.unit();
  made.scene.effects.push_back(Drag{decay * made.scene.particles.mass[made.grid.at(1, 1)]});
  return made;
}

Scene make(Extent extent) {
  return made(extent).scene;
}

/// Puts the first corner, which is pinned, elsewhere by this [m] along each axis.
void teleport(WatchedRun<double>& run, double distance) {
  Snapshot<double> snapshot = run.snapshot();
  for (int axis = 0; axis < 3; ++axis) snapshot.positions[std::size_t(axis)] += distance;
  run.place(snapshot);
}

/// The share of the springs that point against the direction that they had.
double share_flipped(const Springs& springs, const std::vector<Vec3>& before,
                     const std::vector<Vec3>& after) {
  std::size_t flipped = 0;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const Index a = springs.first[s], b = springs.second[s];
    flipped += (before[b] - before[a]).dot(after[b] - after[a]) < 0.0;
  }
  return double(flipped) / double(springs.size());
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    run.take(300);  // so that it hangs at rest
    const std::vector<Vec3> before = run.positions();
    teleport(run, away);
    run.take(1);
    teleport(run, -away);
    run.take(600);
    const std::vector<Vec3> after = run.positions();
    judge.at_most("share of the springs that point the other way 10 s later",
                  share_flipped(scene.springs, before, after), 0.01);
    judge.at_most("distance from where it hung before [m]", largest_distance(before, after), 0.05);
  };
  return judged(scene, asked_of(method, scene, frame), 10, drive);
}

}  // namespace

const HardCase teleported_pin{12,
                              "teleported_pin",
                              "A cloth of 16 x 16 particles (quick: 8 x 8) hangs by two corners in gravity, "
                              "with damped springs (0.05 N s/m) and "
                              "drag (speed decays with 4/s). One corner is put 1000 m away to the side and "
                              "up at once, and put back after one "
                              "step of 1/60 s. 10 s.",
                              "10 s later at most 1 % of the springs point against the direction that they "
                              "had, and every particle is within 5 cm "
                              "of where it hung.",
                              "",
                              frame,
                              make,
                              run,
                              true};

}  // namespace hooke::hard
