#include <algorithm>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/measures.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr double decay = 2.0;  // [1/s] of a particle's speed by drag
constexpr double spacing = 0.1;

Scene make(Extent extent) {
  const Index side = extent == Extent::whole ? 6 : 4;
  Scene scene;
  add(scene, Block{.nx = side, .ny = side, .nz = side, .spacing = spacing, .damping = 0.2});
  Noise noise(9);
  for (Vec3& position : scene.particles.position) position.z() = 1e-6 * noise.unit();
  scene.effects = {Drag{decay * 100.0 * spacing * spacing * spacing}};
  return scene;
}

double thickness(const std::vector<Vec3>& positions) {
  double low = 0.0, high = 0.0;
  for (const Vec3& position : positions) {
    low = std::min(low, position.z());
    high = std::max(high, position.z());
  }
  return high - low;
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    const double at_first = largest_force(scene, scene.particles.position);
    run.take(900);
    judge.at_most("largest force at the end, as a share of the largest at the start",
                  largest_force(scene, run.positions()) / at_first, 1e-6);
    judge.at_least("thickness at the end, in cells", thickness(run.positions()) / spacing, 0.5);
    const double share = share_within(scene, run.positions(), 0.01);
    judge.flag(share == 1.0 ? "it is as it was"
                            : "it rests in another equilibrium: " + std::to_string(100.0 * share) +
                                  " % of the springs are within 1 % of their rest length");
  };
  return judged(scene, asked_of(method, scene, frame), 10, drive);
}

}  // namespace

const HardCase flattened_block{
    9,
    "flattened_block",
    "A free block of 6 x 6 x 6 particles (quick: 4 x 4 x 4) 0.1 m apart, pressed flat to z = 0 but for noise "
    "of 1e-6 "
    "m, with damped springs (0.2 N s/m) and drag (speed decays with 2/s). 15 s in steps of 1/60 s.",
    "It leaves its plane and comes to rest: no force is above 1e-6 of the largest at the start. Which "
    "equilibrium it "
    "rests in is told.",
    "That it is a block again: springs know lengths and no volume, so layers that fold through each other "
    "can rest "
    "so.",
    frame,
    make,
    run};

}  // namespace hooke::hard
