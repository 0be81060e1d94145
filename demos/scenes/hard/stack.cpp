#include <algorithm>
#include <cmath>
#include <string>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/contact_watch.h"
#include "scenes/hard/measures.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr double step = 0.005, friction = 0.4, thickness = 0.002;  // [s], [1], [m]
constexpr int steps_of_second = 200;
constexpr double radius = 0.1, width = 0.4, edge = 0.05;  // [m], of the cylinder, a sheet, a block

/// Sheets that fall on a lying cylinder.
Scene sheets(Extent extent) {
  Scene scene;
  const bool whole = extent == Extent::whole;
  for (int i = 0; i < (whole ? 3 : 2); ++i)
    add_level_cloth(scene, whole ? 10 : 8, width, {0.0, radius + (i + 1) * 1.5 * thickness, 0.0});
  const Collider cylinder{.shape = CapsuleShape{{0.0, 0.0, -0.5}, {0.0, 0.0, 0.5}, radius},
                          .thickness = 0.5 * thickness,
                          .friction = friction};
  scene.effects = {Gravity{}, Drag{1e-3}, cylinder,
                   SelfCollision{.thickness = thickness, .friction = friction}};
  return scene;
}

/// Soft blocks, each on the one before.
Scene blocks(Extent extent) {
  Scene scene;
  for (int i = 0; i < (extent == Extent::whole ? 10 : 3); ++i)
    add(scene, soft_block(edge, {0.0, thickness + i * (edge + 1.5 * thickness), 0.0}));
  scene.effects = {Gravity{}, Drag{2e-3},
                   Collider{.shape = PlaneShape{}, .thickness = 0.5 * thickness, .friction = friction},
                   SelfCollision{.thickness = thickness, .friction = friction}};
  return scene;
}

/// What particles do in a second, by the ways that they go.
struct Second {
  std::vector<Vec3> mean;  ///< places [m]
  double kinetic = 0.0;    ///< energy of the ways of a step, the most [J]
};

Second watch_second(WatchedRun<double>& run, const Scene& scene) {
  Second second;
  std::vector<Vec3> before = run.positions(), velocity(before.size());
  second.mean.assign(before.size(), Vec3::Zero());
  for (int n = 0; n < steps_of_second && run.take(1); ++n) {
    const std::vector<Vec3> now = run.positions();
    for (std::size_t i = 0; i < now.size(); ++i) {
      second.mean[i] += now[i] / steps_of_second;
      velocity[i] = (now[i] - before[i]) / step;
    }
    second.kinetic = std::max(second.kinetic, kinetic_energy(scene, velocity));
    before = now;
  }
  return second;
}

/// Lets a scene come to rest, and looks at it then and after as long again, where it does not end badly
/// before.
void rest(WatchedRun<double>& run, const Scene& scene, const std::string& what, int seconds, Judge& judge) {
  ContactWatch watch(scene, 0.2);
  bool holds = true;
  const auto wait = [&](int for_seconds) {
    for (int s = 0; s < 10 * for_seconds && holds; ++s)
      holds = run.take(steps_of_second / 10) && watch.look(run);
  };
  wait(seconds - 1);
  const Second first = watch_second(run, scene);
  wait(seconds - 1);
  const Second second = watch_second(run, scene);
  watch.judge(judge);
  if (!run.trouble().empty()) judge.wrong(run.trouble());
  if (!holds) return;
  judge.at_most("kinetic energy of the " + what + " at rest [J]", std::max(first.kinetic, second.kinetic),
                1e-6);
  judge.at_most("creep of the " + what + " [mm/min]",
                largest_distance(first.mean, second.mean) / seconds * 60e3, 1.0);
}

Result run(const Method& method, Extent extent) {
  const Scene cloth = sheets(extent), tower = blocks(extent);
  const Settings settings = asked_of(method, cloth, step);
  const int seconds = extent == Extent::whole ? 10 : 3;
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    WatchedRun<double> other(tower, settings);
    rest(other, tower, "blocks", seconds, judge);
    rest(run, cloth, "sheets", seconds, judge);
  };
  return judged(cloth, settings, 5, drive);
}

}  // namespace

const HardCase stack{29,
                     "stack",
                     "Three sheets of 0.4 m, 10 x 10 particles (quick: two of 8 x 8; asked are 50 of 32 x "
                     "32), fall on a lying cylinder of 0.1 m, and "
                     "ten soft blocks of 5 cm, 3 x 3 x 3 particles each (quick: three), lie on one another; "
                     "thickness 2 mm, mu 0.4, drag. 20 s "
                     "(quick: 6 s) in steps of 5 ms.",
                     "At rest after half of the time: the ways that particles go in a step have a kinetic "
                     "energy below 1e-6 J, and where they are on the mean of a second "
                     "changes by less than 1 mm/min from then to the end. No edge passes through a triangle, "
                     "no spring is longer by more than 20 %.",
                     "",
                     step,
                     sheets,
                     run,
                     true};

}  // namespace hooke::hard
