#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/contact_watch.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr double step = 0.01, friction = 0.2, gravity = 9.81, thickness = 0.004;  // [s], [1], [m/s^2], [m]
constexpr double width = 0.4, edge = 0.05;                                        // [m], of a block

constexpr double begin = 0.3, drop = 0.005;  // [s] of the pull

/// A cloth on a table, with soft blocks on it, and what draws its edge away to the right.
struct Laid {
  Scene scene;
  std::vector<BlockParticles> blocks;
};

Laid lay(Extent extent, double speed) {
  Laid laid;
  Scene& scene = laid.scene;
  const bool whole = extent == Extent::whole;
  const Index side = whole ? 16 : 9;
  const GridParticles cloth = add_level_cloth(scene, side, width, {0.0, 0.5 * thickness, 0.0});
  for (int i = 0; i < (whole ? 3 : 1); ++i) {
    const double z = whole ? 0.12 * (i - 1) : 0.0;
    laid.blocks.push_back(
        add(scene, soft_block(edge, {-0.5 * edge, 1.5 * thickness + drop, z - 0.5 * edge})));
  }
  FrameAttachment front;
  for (Index row = 0; row < side; ++row) front.particles.push_back(cloth.at(side - 1, row));
  front.path = {{begin, Vec3::Zero(), 0.0}, {begin + 10.0, Vec3(10.0 * speed, 0.0, 0.0), 0.0}};
  scene.effects = {Gravity{{0.0, -gravity, 0.0}}, Drag{2e-5}, front,
                   Collider{.shape = PlaneShape{}, .thickness = 0.5 * thickness, .friction = friction},
                   SelfCollision{.thickness = thickness, .friction = friction}};
  return laid;
}

Scene make(Extent extent) {
  return lay(extent, 4.0).scene;
}

/// How far the blocks have gone to the right [m]: the least and the most.
struct Ways {
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
};

Ways ways_of(const Laid& laid, const std::vector<Vec3>& positions) {
  Ways ways;
  for (const BlockParticles& block : laid.blocks) {
    const Index count = block.nx * block.ny * block.nz;
    double way = 0.0;
    for (Index i = block.first; i < block.first + count; ++i)
      way += (positions[i].x() - laid.scene.particles.position[i].x()) / double(count);
    ways.least = std::min(ways.least, way);
    ways.most = std::max(ways.most, way);
  }
  return ways;
}

/// Draws the cloth away. None where that ends badly, which is judged.
std::optional<Ways> pull(WatchedRun<double>& run, const Laid& laid, int steps, Judge& judge) {
  ContactWatch watch(laid.scene, 0.3);
  int taken = 0;
  while (taken < steps && run.take(1) && watch.look(run)) ++taken;
  watch.judge(judge);
  if (!run.trouble().empty()) judge.wrong(run.trouble());
  if (taken < steps) return {};
  return ways_of(laid, run.positions());
}

Result run(const Method& method, Extent extent) {
  const Laid fast = lay(extent, 4.0), middling = lay(extent, 1.0), slow = lay(extent, 0.1);
  const Settings settings = asked_of(method, fast.scene, step);
  const int steps = extent == Extent::whole ? 300 : 100;
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    WatchedRun<double> at_1(middling.scene, settings), at_a_tenth(slow.scene, settings);
    if (const auto ways = pull(run, fast, steps, judge))
      judge.at_most("way of a block when the cloth is drawn at 4 m/s [m]", ways->most, 0.02);
    if (const auto ways = pull(at_1, middling, steps, judge))
      judge.flag("at 1 m/s it goes " + std::to_string(ways->most) + " m");
    if (const auto ways = pull(at_a_tenth, slow, steps, judge)) {
      const double way = 0.1 * (steps * step - begin);
      judge.at_least("the same at 0.1 m/s, over the cloth's", ways->least / way, 0.9);
      judge.at_most("the same at 0.1 m/s, over the cloth's", ways->most / way, 1.1);
    }
  };
  return judged(fast.scene, settings, 5, drive);
}

}  // namespace

const HardCase table_cloth{
    27,
    "table_cloth",
    "A cloth of 40 cm, 16 x 16 particles (quick: 9 x 9), on a table, and on it three soft blocks of 5 cm, 38 "
    "g (quick: one), of 3 x 3 x 3 "
    "particles each. After 0.3 s its edge is drawn along the table at 4 m/s; and again at 1 m/s, and at "
    "0.1 m/s. Thickness 4 mm, mu 0.2 everywhere. 300 steps of 0.01 s (quick: 100).",
    "At 4 m/s the blocks stay: they go by less than 2 cm. At 0.1 m/s they are carried along, by 90 to 110 % "
    "of the "
    "cloth's way. No edge passes through a triangle, no spring is longer by more than 30 %.",
    "How far blocks go at 1 m/s, which is told.",
    step,
    make,
    run};

}  // namespace hooke::hard
