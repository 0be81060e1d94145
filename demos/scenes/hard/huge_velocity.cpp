#include <algorithm>
#include <limits>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr double speed = 1e4;  // [m/s]

/// A cloth that flies at a thin wall 1 m ahead of it.
Scene make(Extent extent) {
  Scene scene = sheet(extent == Extent::whole ? 24 : 12).scene;
  scene.particles.velocity.assign(scene.particles.size(), {0.0, 0.0, -speed});
  scene.effects = {Collider{.shape = BoxShape{{0.5, -0.5, -1.005}, {2.0, 2.0, 0.005}}}};
  return scene;
}

/// How far the particle that is furthest back is in front of the wall [m].
double least_gap(const std::vector<Vec3>& positions) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& position : positions) least = std::min(least, position.z() + 1.0);
  return least;
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 60 && run.take(1); ++i) least = std::min(least, least_gap(run.positions()));
    judge.at_least("least distance in front of the wall [m]", least, -1e-6);
  };
  return judged(scene, asked_of(method, scene, frame), 20, drive);
}

}  // namespace

const HardCase huge_velocity{13,
                             "huge_velocity",
                             "A free cloth of 24 x 24 particles (quick: 12 x 12) flies at 1e4 m/s flat at a "
                             "wall of 1 cm, a box collider 1 m "
                             "ahead. 1 s in steps of 1/60 s, in one of which it would fly 167 m.",
                             "No particle is ever inside of the wall, or behind it, by more than 1e-6 m. "
                             "Energy does not rise, by the common "
                             "criterion.",
                             "A thin cloth as the wall.",
                             frame,
                             make,
                             run};

}  // namespace hooke::hard
